#include "opencv2/ts.hpp"
#include "opencv2/gwatershed.hpp"
