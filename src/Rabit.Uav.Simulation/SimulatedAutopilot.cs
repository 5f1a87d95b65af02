namespace Rabit.Uav.Simulation;

/// <summary>The autopilots that the simulated vehicle can fly with.</summary>
public enum SimulatedAutopilot
{
    /// <summary>As ArduPilot's Copter 4.x.</summary>
    ArduPilot,

    /// <summary>As PX4 1.14 with a multirotor.</summary>
    Px4,
}
