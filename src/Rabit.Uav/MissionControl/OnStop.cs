namespace Rabit.Uav.MissionControl;

/// <summary>What Mission Control commands when the program is stopped while it flies the vehicle.</summary>
public enum OnStop
{
    /// <summary>Hold the position.</summary>
    Hold,

    /// <summary>Return to launch (RTL) and land there.</summary>
    Return,
}
