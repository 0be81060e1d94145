#include "collide/contact_sweeps.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "parallel/sum.h"

namespace hooke {
namespace {

/// Contacts that one thread takes at a time: some microseconds of work.
constexpr std::size_t contacts_in_run = 256;

/// A particle is not moved by more than so many times what the contact lacks.
constexpr double most_leverage = 10.0;

/// After so many sweeps over what pushes, all are looked at again.
constexpr std::uint64_t active_sweeps = 7;

/// Pushes that have been before are not made larger than so many times: where they are against each other,
/// hardly anything moves by however much, and sweeps would have to take all of it back. What has fallen
/// freely through a step of many substeps asks for twice as much in its velocity as in its way.
constexpr double most_factor = 2.0;

constexpr unsigned no_colour = ~0u, colours_at_once = 64;

Eigen::Map<const Vec3> vector_of(const std::array<double, 4>& four) {
  return Eigen::Map<const Vec3>(four.data());
}
Eigen::Map<Vec3> vector_at(AlignedVector<double>& values, std::size_t place) {
  return Eigen::Map<Vec3>(&values[4 * place]);
}
Eigen::Map<const Vec3> vector_at(const AlignedVector<double>& values, std::size_t place) {
  return Eigen::Map<const Vec3>(&values[4 * place]);
}

template <class Visit>
void for_each_moved(const SurfaceContact& contact, const std::vector<double>& inverse_mass,
                    const Visit& visit) {
  for (std::size_t k = 0; k < 4; ++k) {
    const Index particle = contact.particles[k];
    if (contact.weights[k] != 0.0 && inverse_mass[particle] > 0.0) visit(particle, contact.weights[k]);
  }
}

}  // namespace

bool can_be_moved(const SurfaceContact& contact, const std::vector<double>& inverse_mass) {
  for (std::size_t k = 0; k < 4; ++k) {
    if (contact.weights[k] != 0.0 && inverse_mass[contact.particles[k]] > 0.0) return true;
  }
  return false;
}

ContactSweeps::ContactSweeps(const std::vector<double>& inverse_mass)
    : inverse_mass_(inverse_mass), taken_(inverse_mass.size(), 0), met_place_(inverse_mass.size()) {}

void ContactSweeps::set(const std::vector<SurfaceContact>& contacts, Executor& executor) {
  choose_colours(contacts);
  contacts_.resize(contacts.size());
  have_pushed_ = std::any_of(contacts.begin(), contacts.end(),
                             [](const SurfaceContact& contact) { return contact.pushed > 0.0; });
  executor.parallel_for(contacts.size(), contacts_in_run, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) contacts_[place_[c]] = packed(contacts[c]);
  });
}

PackedContact ContactSweeps::packed(const SurfaceContact& contact) const {
  PackedContact packed{{contact.normal.x(), contact.normal.y(), contact.normal.z(), 0.0},
                       {contact.held.x(), contact.held.y(), contact.held.z(), 0.0},
                       contact.weights,
                       contact.least,
                       contact.friction,
                       0.0,
                       {},
                       contact.pushed,
                       {contact.held_back.x(), contact.held_back.y(), contact.held_back.z(), 0.0}};
  double sum = 0.0, largest = 0.0;
  for_each_moved(contact, inverse_mass_, [&](Index i, double weight) {
    sum += weight * weight * inverse_mass_[i];
    largest = std::max(largest, std::abs(weight) * inverse_mass_[i]);
  });
  // Where a particle that is far from the place where they touch is the only one that can move, it would have
  // to go very far: it goes a part of the way.
  packed.mass = 1.0 / std::max(sum, largest / most_leverage);
  for (std::size_t k = 0; k < 4; ++k) packed.places[k] = met_place_[contact.particles[k]];
  return packed;
}

void ContactSweeps::tell_push(std::size_t contact, double scale, SurfaceContact& next) const {
  const PackedContact& packed = contacts_[place_[contact]];
  next.pushed = scale * packed.pushed;
  next.held_back = scale * vector_of(packed.held_back);
}

void ContactSweeps::find_particles(const std::vector<SurfaceContact>& contacts) {
  met_.clear();
  for (const SurfaceContact& contact : contacts) {
    for (const Index i : contact.particles) {
      if (taken_[i] == 0) met_.push_back(i);
      taken_[i] = 1;
    }
  }
  std::sort(met_.begin(), met_.end());
  particles_.clear();
  for (std::size_t m = 0; m < met_.size(); ++m) {
    met_place_[met_[m]] = Index(m);
    taken_[met_[m]] = 0;
    if (inverse_mass_[met_[m]] > 0.0) particles_.push_back(met_[m]);
  }
}

/// Each contact gets the first colour that none of its particles has; where 64 do not suffice, the rest are
/// coloured anew with the next 64.
void ContactSweeps::choose_colours(const std::vector<SurfaceContact>& contacts) {
  colour_.assign(contacts.size(), no_colour);
  colour_begin_.assign(1, 0);
  std::size_t left = contacts.size();
  for (unsigned first = 0; left > 0; first += colours_at_once) {
    for (const Index particle : met_) taken_[particle] = 0;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      if (colour_[c] != no_colour) continue;
      std::uint64_t taken = 0;
      for_each_moved(contacts[c], inverse_mass_, [&](Index i, double) { taken |= taken_[i]; });
      const auto colour = unsigned(std::countr_one(taken));
      if (colour == colours_at_once) continue;
      for_each_moved(contacts[c], inverse_mass_,
                     [&](Index i, double) { taken_[i] |= std::uint64_t(1) << colour; });
      colour_[c] = first + colour;
      colour_begin_.resize(std::max<std::size_t>(colour_begin_.size(), first + colour + 2), 0);
      ++colour_begin_[first + colour + 1];
      --left;
    }
  }
  for (const Index particle : met_) taken_[particle] = 0;
  for (std::size_t k = 1; k < colour_begin_.size(); ++k) colour_begin_[k] += colour_begin_[k - 1];
  place_.resize(contacts.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) place_[c] = Index(colour_begin_[colour_[c]]++);
  for (std::size_t k = colour_begin_.size(); k-- > 1;) colour_begin_[k] = colour_begin_[k - 1];
  colour_begin_[0] = 0;
}

void ContactSweeps::load(const std::vector<Vec3>& values) {
  values_.resize(4 * met_.size());
  for (std::size_t m = 0; m < met_.size(); ++m) {
    vector_at(values_, m) = values[met_[m]];
    values_[4 * m + 3] = inverse_mass_[met_[m]];
  }
}

void ContactSweeps::store(std::vector<Vec3>& values) const {
  for (std::size_t m = 0; m < met_.size(); ++m) values[met_[m]] = vector_at(values_, m);
}

ContactSweeps::Outcome ContactSweeps::run(std::vector<Vec3>& values, const Enough& enough, std::uint64_t most,
                                          Executor& executor) {
  load(values);
  const double asked_before = have_pushed_ ? begin_from_pushes(executor) : 0.0;
  double at_end = enough.least;
  std::uint64_t sweeps = 0;
  while (sweeps < most) {
    const double asked = sweep(contacts_, colour_begin_, executor);
    if (sweeps == 0)
      at_end = std::clamp(enough.share * std::max(asked, asked_before), enough.least, enough.most);
    ++sweeps;
    if (!(asked > at_end)) break;
    if (!choose_active(executor)) continue;
    for (std::uint64_t n = 0; n < active_sweeps && sweeps < most; ++n) {
      ++sweeps;
      if (!(sweep(active_, active_begin_, executor) > at_end)) break;
    }
    for_each_active(executor, [](const PackedContact& active, PackedContact& contact) { contact = active; });
  }
  store(values);
  return {sweeps, at_end};
}

/// Sweeps lead to the change of values, of pushes p, with the least e = half the sum of mass times change
/// squared, less p times what contacts lack before: along known pushes e is least where its slope is zero.
/// Returns the most that a contact lacked.
double ContactSweeps::begin_from_pushes(Executor& executor) {
  before_ = values_;
  const Work work = work_of_pushes(executor);
  add_pushes(executor);
  const double factor = work.done / energy_of_change();
  scale_change(factor > 0.0 ? std::min(factor, most_factor) : 0.0, executor);
  return work.lacks;
}

ContactSweeps::Work ContactSweeps::work_of_pushes(Executor& executor) {
  const auto part = [&](std::size_t begin, std::size_t end) {
    Work work;
    for (std::size_t c = begin; c < end; ++c) {
      const PackedContact& contact = contacts_[c];
      Vec3 r = Vec3::Zero();
      for (std::size_t k = 0; k < 4; ++k) r += contact.weights[k] * vector_at(values_, contact.places[k]);
      const double lacks = contact.least - r.dot(vector_of(contact.normal));
      const double slides = vector_of(contact.held_back).dot(r - vector_of(contact.held));
      work.add({contact.mass * (contact.pushed * lacks + slides), lacks});
    }
    return work;
  };
  return sum_in_order<Work>(executor, contacts_.size(), contacts_in_run, part, work_);
}

void ContactSweeps::add_pushes(Executor& executor) {
  for_each_in_colours(executor, [&](PackedContact& contact) {
    const Vec3 change = contact.pushed * vector_of(contact.normal) - vector_of(contact.held_back);
    for (std::size_t k = 0; k < 4; ++k) {
      const double inverse_mass = values_[4 * contact.places[k] + 3];
      const double share = contact.weights[k] * inverse_mass * contact.mass;
      if (share != 0.0) vector_at(values_, contact.places[k]) += share * change;
    }
  });
}

/// The sum of mass times change squared [kg values^2].
double ContactSweeps::energy_of_change() const {
  double energy = 0.0;
  for (std::size_t m = 0; m < met_.size(); ++m) {
    const double inverse_mass = values_[4 * m + 3];
    if (inverse_mass > 0.0)
      energy += (vector_at(values_, m) - vector_at(before_, m)).squaredNorm() / inverse_mass;
  }
  return energy;
}

void ContactSweeps::scale_change(double factor, Executor& executor) {
  const auto scaled = [&](double value) { return factor > 0.0 ? factor * value : 0.0; };
  for (std::size_t v = 0; v < values_.size(); ++v) values_[v] = before_[v] + scaled(values_[v] - before_[v]);
  for_each_in_colours(executor, [&](PackedContact& contact) {
    contact.pushed = scaled(contact.pushed);
    for (double& held_back : contact.held_back) held_back = scaled(held_back);
  });
}

/// Never two that share a particle at once.
template <class Visit>
void ContactSweeps::for_each_in_colours(Executor& executor, const Visit& visit) {
  for (std::size_t colour = 0; colour + 1 < colour_begin_.size(); ++colour) {
    const std::size_t first = colour_begin_[colour];
    executor.parallel_for(colour_begin_[colour + 1] - first, contacts_in_run,
                          [&](std::size_t begin, std::size_t end) {
                            for (std::size_t c = first + begin; c < first + end; ++c) visit(contacts_[c]);
                          });
  }
}

double ContactSweeps::sweep(std::span<PackedContact> contacts, const std::vector<std::size_t>& colour_begin,
                            Executor& executor) {
  double largest = 0.0;
  for (std::size_t colour = 0; colour + 1 < colour_begin.size(); ++colour) {
    const std::size_t first = colour_begin[colour];
    const auto part = [&](std::size_t begin, std::size_t end) {
      return Largest{push_contacts(contacts.subspan(first + begin, end - begin), values_.data())};
    };
    const Largest asked =
        sum_in_order<Largest>(executor, colour_begin[colour + 1] - first, contacts_in_run, part, largest_);
    largest = std::max(largest, asked.value);
  }
  return largest;
}

/// Those that push. Whether they are so much fewer that it pays.
bool ContactSweeps::choose_active(Executor& executor) {
  const std::size_t colours = colour_begin_.size() - 1;
  active_begin_.assign(colours + 1, 0);
  executor.parallel_for(colours, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t colour = begin; colour < end; ++colour)
      active_begin_[colour + 1] =
          std::size_t(std::count_if(contacts_.begin() + std::ptrdiff_t(colour_begin_[colour]),
                                    contacts_.begin() + std::ptrdiff_t(colour_begin_[colour + 1]),
                                    [](const PackedContact& contact) { return contact.pushed > 0.0; }));
  });
  for (std::size_t colour = 0; colour < colours; ++colour) active_begin_[colour + 1] += active_begin_[colour];
  if (3 * active_begin_.back() > 2 * contacts_.size()) return false;
  active_.resize(active_begin_.back());
  for_each_active(executor, [](PackedContact& active, const PackedContact& contact) { active = contact; });
  return true;
}

/// Each of those, and what it is one of.
template <class Visit>
void ContactSweeps::for_each_active(Executor& executor, const Visit& visit) {
  executor.parallel_for(active_begin_.size() - 1, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t colour = begin; colour < end; ++colour) {
      std::size_t next = active_begin_[colour];
      for (std::size_t c = colour_begin_[colour]; c < colour_begin_[colour + 1]; ++c) {
        if (contacts_[c].pushed > 0.0) visit(active_[next++], contacts_[c]);
      }
    }
  });
}

std::size_t ContactSweeps::bytes() const {
  return (contacts_.capacity() + active_.capacity()) * sizeof(PackedContact) +
         (place_.capacity() + particles_.capacity() + met_.capacity() + met_place_.capacity()) *
             sizeof(Index) +
         (colour_begin_.capacity() + active_begin_.capacity()) * sizeof(std::size_t) +
         colour_.capacity() * sizeof(unsigned) + taken_.capacity() * sizeof(std::uint64_t) +
         (values_.capacity() + before_.capacity()) * sizeof(double) + work_.capacity() * sizeof(Work);
}

}  // namespace hooke
