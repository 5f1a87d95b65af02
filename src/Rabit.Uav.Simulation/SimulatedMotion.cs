namespace Rabit.Uav.Simulation;

/// <summary>How a target of the simulated world moves.</summary>
public enum SimulatedMotion
{
    /// <summary>It stays where it is.</summary>
    Standing = 0,

    /// <summary>On foot: straight on at about 1.4 m/s, with pauses of 3 to 15 s at each turn.</summary>
    Walking = 1,

    /// <summary>A vehicle on a closed road: up to 8 m/s, 3 m/s in the curves, of 6 m radius.</summary>
    Vehicle = 2,

    /// <summary>Short ways at 0.5 to 3 m/s, with a stop of up to 1 s and another course after each.</summary>
    Erratic = 3,

    /// <summary>A vehicle on a closed road at a steady 8 m/s, in curves of 25 m radius too.</summary>
    SteadyVehicle = 4,
}
