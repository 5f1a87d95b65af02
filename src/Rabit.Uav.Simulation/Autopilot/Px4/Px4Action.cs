namespace Rabit.Uav.Simulation;

/// <summary>What a failsafe does, by PX4's own numbers; the higher one wins.</summary>
internal enum Px4Action
{
    None = 0,
    Warn = 1,
    PositionControl = 2,
    AltitudeControl = 3,
    Hold = 5,
    Return = 6,
    Land = 7,
    Descend = 8,
}
