namespace Rabit.Uav.Simulation.Tests.FaultMatrix;

/// <summary>How a flight of the fault matrix ends, by the truth and by the report, which must agree.</summary>
internal enum MatrixEnd
{
    /// <summary>None of the others.</summary>
    Undefined,

    /// <summary>The mission goes on and is accomplished.</summary>
    Accomplished,

    /// <summary>The mission is given up; the vehicle returns and lands at home.</summary>
    ReturnsAndLands,

    /// <summary>The vehicle lands elsewhere than at home, or where is not known.</summary>
    LandsWhereItIs,

    /// <summary>No progress: the vehicle holds, then returns and lands at home.</summary>
    HoldsThenReturns,

    /// <summary>Handed over: the pilot's or ground station's mode stands, nothing more is sent.</summary>
    PilotHasIt,

    /// <summary>Handed over: the autopilot's failsafe acts, nothing more is sent.</summary>
    FailsafeHasIt,

    /// <summary>Handed over: another commander's target stands, nothing more is sent.</summary>
    OtherCommanderHasIt,

    /// <summary>Handed over: the autopilot has rebooted, nothing more is sent.</summary>
    Rebooted,

    /// <summary>The vehicle falls, and the report claims neither a landing nor a mission accomplished.</summary>
    Falls,

    /// <summary>Reported failed: the vehicle stands on the ground, disarmed, without a command of ours.</summary>
    LandedWithoutUs,

    /// <summary>The program ends once the vehicle holds.</summary>
    HoldsAtStop,

    /// <summary>The program ends and leaves the vehicle in its return or landing.</summary>
    StopsInItsReturn,
}
