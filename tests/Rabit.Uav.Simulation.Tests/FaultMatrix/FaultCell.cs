using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation.Tests.FaultMatrix;

/// <summary>One flight of the matrix, and how it has to end.</summary>
/// <param name="Fault">What goes wrong.</param>
/// <param name="Phase">In which phase.</param>
/// <param name="Model">With which autopilot.</param>
/// <param name="Expected">How it has to end.</param>
/// <param name="Reason">Why so.</param>
/// <param name="Seed">Of the world and of the order of events.</param>
internal sealed record FaultCell(
    MatrixFault Fault, MissionPhase Phase, SimulatedAutopilot Model, MatrixEnd Expected, string Reason, long Seed)
{
    /// <summary>Why it does not end as expected yet; null where it does.</summary>
    public string? Known { get; init; }

    public override string ToString()
        => FormattableString.Invariant($"{Model}, {Fault.Name}, {Phase} (seed {Seed})");
}
