#include "program/program.h"

int main(int argc, char** argv) {
  return hooke::program::run_program(argc, argv);
}
