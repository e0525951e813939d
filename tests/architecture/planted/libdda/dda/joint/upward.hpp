#pragma once
#include "dda/base/types.hpp"
#include "dda/contact/contact.hpp"
