using System;

namespace Rabit.Uav.Simulation;

/// <summary>Something that goes wrong with a whole vehicle of a simulated group. Immutable.</summary>
/// <param name="Vehicle">The vehicle, from 0.</param>
/// <param name="Kind">What.</param>
/// <param name="At">When, by the clock of the group.</param>
public sealed record SimulatedGroupFault(int Vehicle, SimulatedGroupFaultKind Kind, TimeSpan At);
