

using Rabit.Core.Diagnostics;
using Rabit.Core.Time;

namespace Rabit.Core.Messages;

/// <summary>What every message has, whatever its type.</summary>
/// <param name="Name">The name.</param>
/// <param name="Clock">The clock of the run.</param>
/// <param name="Log">The log of the run.</param>
internal sealed record MessagePlace(string Name, RunClock Clock, RabitLog Log);
