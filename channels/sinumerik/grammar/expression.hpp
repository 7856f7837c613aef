// Expressions: the value at the cursor.
#pragma once
namespace polyturn::channels::sinumerik {

struct Execution;
struct Value;

bool expression(Execution& x, Value& value);
bool number_of(Execution& x, const Value& value, const char* at, double& number);

}  // namespace polyturn::channels::sinumerik
