

using Rabit.Core.Diagnostics;
using Rabit.Core.Time;

namespace Rabit.Core.Messages;

/// <summary>What every message has, whatever its type.</summary>
internal sealed record MessagePlace(string Name, RunClock Clock, RabitLog Log);
