#include "engine/response/energy_account.h"

namespace gurney {

double EnergyAccount::loss() const {
  return rolling_loss + sliding_loss + relaxation_loss + tread_loss + axle_loss + swivel_loss +
         damper_loss + contact_loss + numerical_loss;
}

}  // namespace gurney
