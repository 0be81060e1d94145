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

constexpr unsigned no_colour = ~0u, colours_at_once = 64;

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
    : inverse_mass_(inverse_mass), taken_(inverse_mass.size(), 0) {}

void ContactSweeps::set(const std::vector<SurfaceContact>& contacts) {
  find_particles(contacts);
  choose_colours(contacts);
  contacts_.resize(contacts.size());
  inverse_masses_.resize(contacts.size());
  pushed_.resize(contacts.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    contacts_[place_[c]] = contacts[c];
    double sum = 0.0, largest = 0.0;
    for_each_moved(contacts[c], inverse_mass_, [&](Index i, double weight) {
      sum += weight * weight * inverse_mass_[i];
      largest = std::max(largest, std::abs(weight) * inverse_mass_[i]);
    });
    // Where a particle that is far from the place where they touch is the only one that can move, it would
    // have to go very far: it goes a part of the way.
    inverse_masses_[place_[c]] = std::max(sum, largest / most_leverage);
  }
}

void ContactSweeps::find_particles(const std::vector<SurfaceContact>& contacts) {
  particles_.clear();
  for (const SurfaceContact& contact : contacts) {
    for_each_moved(contact, inverse_mass_, [&](Index i, double) {
      if (taken_[i] == 0) particles_.push_back(i);
      taken_[i] = 1;
    });
  }
  std::sort(particles_.begin(), particles_.end());
}

/// Each contact gets the first colour that none of its particles has; where 64 do not suffice, the rest are
/// coloured anew with the next 64.
void ContactSweeps::choose_colours(const std::vector<SurfaceContact>& contacts) {
  colour_.assign(contacts.size(), no_colour);
  colour_begin_.assign(1, 0);
  std::size_t left = contacts.size();
  for (unsigned first = 0; left > 0; first += colours_at_once) {
    for (const Index particle : particles_) taken_[particle] = 0;
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
  for (const Index particle : particles_) taken_[particle] = 0;
  for (std::size_t k = 1; k < colour_begin_.size(); ++k) colour_begin_[k] += colour_begin_[k - 1];
  place_.resize(contacts.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) place_[c] = Index(colour_begin_[colour_[c]]++);
  for (std::size_t k = colour_begin_.size(); k-- > 1;) colour_begin_[k] = colour_begin_[k - 1];
  colour_begin_[0] = 0;
}

std::uint64_t ContactSweeps::run(std::vector<Vec3>& values, double share, double least, std::uint64_t most,
                                 Executor& executor) {
  std::fill(pushed_.begin(), pushed_.end(), std::uint8_t(0));
  double enough = least;
  for (std::uint64_t sweeps = 0; sweeps < most;) {
    const double asked = sweep(values, executor);
    if (sweeps == 0) enough = std::max(least, share * asked);
    ++sweeps;
    if (!(asked > enough)) return sweeps;
  }
  return most;
}

double ContactSweeps::sweep(std::vector<Vec3>& values, Executor& executor) {
  double largest = 0.0;
  for (std::size_t colour = 0; colour + 1 < colour_begin_.size(); ++colour) {
    const std::size_t first = colour_begin_[colour];
    const auto part = [&](std::size_t begin, std::size_t end) {
      Largest asked;
      for (std::size_t c = first + begin; c < first + end; ++c) asked.add({push(c, values)});
      return asked;
    };
    const Largest asked =
        sum_in_order<Largest>(executor, colour_begin_[colour + 1] - first, contacts_in_run, part, largest_);
    largest = std::max(largest, asked.value);
  }
  return largest;
}

double ContactSweeps::push(std::size_t place, std::vector<Vec3>& values) {
  const SurfaceContact& contact = contacts_[place];
  const Vec3 r = contact.sum(values);
  const double depth = contact.least - contact.normal.dot(r);
  if (!(depth > 0.0)) return 0.0;
  pushed_[place] = 1;
  Vec3 change = depth * contact.normal;
  if (contact.friction > 0.0) {
    const Vec3 moved = r - contact.held, along = moved - moved.dot(contact.normal) * contact.normal;
    const double length = along.norm(), most = contact.friction * depth;
    change -= (length > most ? most / length : 1.0) * along;
  }
  const Vec3 impulse = change / inverse_masses_[place];
  for_each_moved(contact, inverse_mass_,
                 [&](Index i, double weight) { values[i] += weight * inverse_mass_[i] * impulse; });
  return depth;
}

std::size_t ContactSweeps::bytes() const {
  return contacts_.capacity() * sizeof(SurfaceContact) + inverse_masses_.capacity() * sizeof(double) +
         pushed_.capacity() + (place_.capacity() + particles_.capacity()) * sizeof(Index) +
         colour_begin_.capacity() * sizeof(std::size_t) + colour_.capacity() * sizeof(unsigned) +
         taken_.capacity() * sizeof(std::uint64_t);
}

}  // namespace hooke
