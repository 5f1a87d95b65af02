namespace Rabit.Uav.Simulation;

/// <summary>How empty an autopilot takes its battery for, from the least severe to the most severe.</summary>
internal enum BatteryLevel
{
    Ok,
    Low,
    Critical,
}
