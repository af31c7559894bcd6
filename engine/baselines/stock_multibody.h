#pragma once

#include <memory>

#include "engine/baselines/stock_model.h"

namespace gurney::baselines {

/// `bullet` and `bullet-dantzig`: a btMultiBody with sphere wheels (one contact point each) on a
/// static plane; rolling resistance, bearing friction and brakes as motors on the axles with the
/// limit Cr N of the last step's normal force. `bullet`: sequential impulse, 50 iterations.
/// `bullet-dantzig`: direct solve, m_globalCfm = 1e-9.
std::unique_ptr<StockModel> make_stock_multibody(const Scene& scene, const Mechanism& mechanism,
                                                 bool direct);

}  // namespace gurney::baselines
