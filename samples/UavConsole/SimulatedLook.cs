using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>What the simulated camera is like.</summary>
internal sealed class SimulatedLook
{
    /// <summary>What holds it.</summary>
    public SimulatedGimbal Gimbal { get; init; }

    /// <summary>Before the world is made.</summary>
    public void ApplyTo(SimulationOptions world) => world.Camera.Gimbal = Gimbal;
}
