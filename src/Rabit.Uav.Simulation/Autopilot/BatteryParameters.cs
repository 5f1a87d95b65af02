using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>ArduCopter's parameters of its first battery monitor, with the defaults of ArduPilot.</summary>
internal sealed class BatteryParameters
{
    private const float PackMilliampereHours = 8000;

    /// <param name="add">Takes a name, a type and a default into the store.</param>
    public BatteryParameters(Func<string, MavParamType, float, Parameter> add)
    {
        Capacity = add("BATT_CAPACITY", MavParamType.Int32, PackMilliampereHours);
        LowVolts = add("BATT_LOW_VOLT", MavParamType.Real32, 10.5f);
        LowCharge = add("BATT_LOW_MAH", MavParamType.Real32, 0);
        CriticalVolts = add("BATT_CRT_VOLT", MavParamType.Real32, 0);
        CriticalCharge = add("BATT_CRT_MAH", MavParamType.Real32, 0);
        LowTimer = add("BATT_LOW_TIMER", MavParamType.Int8, 10);
        LowAction = add("BATT_FS_LOW_ACT", MavParamType.Int8, 0);
        CriticalAction = add("BATT_FS_CRT_ACT", MavParamType.Int8, 0);
        ArmVolts = add("BATT_ARM_VOLT", MavParamType.Real32, 0);
    }

    /// <summary>mAh.</summary>
    public Parameter Capacity { get; }

    /// <summary>0: not checked.</summary>
    public Parameter LowVolts { get; }

    /// <summary>mAh left; 0: not checked.</summary>
    public Parameter LowCharge { get; }

    /// <summary>0: not checked.</summary>
    public Parameter CriticalVolts { get; }

    /// <summary>mAh left; 0: not checked.</summary>
    public Parameter CriticalCharge { get; }

    /// <summary>Seconds that the voltage must be low.</summary>
    public Parameter LowTimer { get; }

    /// <summary>See <see cref="FailsafeAction"/>.</summary>
    public Parameter LowAction { get; }

    /// <summary>See <see cref="FailsafeAction"/>.</summary>
    public Parameter CriticalAction { get; }

    /// <summary>0: not checked.</summary>
    public Parameter ArmVolts { get; }
}
