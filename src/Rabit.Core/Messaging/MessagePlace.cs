using Rabit.Core.Diagnostics;

namespace Rabit.Core.Messaging;

/// <summary>What every message has, whatever its type.</summary>
internal sealed record MessagePlace(string Name, RunClock Clock, RabitLog Log);
