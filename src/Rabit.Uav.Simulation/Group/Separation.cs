using System;

namespace Rabit.Uav.Simulation;

/// <summary>How near two vehicles of a simulated group came to each other in the air. Immutable.</summary>
/// <param name="First">The one vehicle, from 0.</param>
/// <param name="Second">The other one.</param>
/// <param name="HorizontalMetres">How far they were apart over ground.</param>
/// <param name="VerticalMetres">How far they were apart in height.</param>
/// <param name="Time">When, by the clock of the group.</param>
public sealed record Separation(int First, int Second, double HorizontalMetres, double VerticalMetres, TimeSpan Time);
