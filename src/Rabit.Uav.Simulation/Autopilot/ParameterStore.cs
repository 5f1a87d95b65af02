using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The parameters, by the names that ArduCopter 4.x gives them, in its units. Those that nothing here reads are only
/// kept.
/// </summary>
internal sealed class ParameterStore
{
    private const float PackMilliampereHours = 8000;

    private readonly List<Parameter> _all = [];

    public ParameterStore()
    {
        SystemId = Add("SYSID_THISMAV", MavParamType.Int16, 1);
        GroundSystemId = Add("SYSID_MYGCS", MavParamType.Int16, 255);
        Add("FRAME_CLASS", MavParamType.Int8, 1);
        ArmingCheck = Add("ARMING_CHECK", MavParamType.Int32, 1);
        DisarmDelay = Add("DISARM_DELAY", MavParamType.Int8, 10);
        Speed = Add("WPNAV_SPEED", MavParamType.Real32, 1000);
        SpeedUp = Add("WPNAV_SPEED_UP", MavParamType.Real32, 250);
        SpeedDown = Add("WPNAV_SPEED_DN", MavParamType.Real32, 150);
        Acceleration = Add("WPNAV_ACCEL", MavParamType.Real32, 250);
        VerticalAcceleration = Add("WPNAV_ACCEL_Z", MavParamType.Real32, 100);
        YawBehaviour = Add("WP_YAW_BEHAVIOR", MavParamType.Int8, 2);
        GuidedTimeout = Add("GUID_TIMEOUT", MavParamType.Real32, 3);
        ReturnHeight = Add("RTL_ALT", MavParamType.Int32, 1500);
        ReturnSpeed = Add("RTL_SPEED", MavParamType.Int16, 0);
        ReturnSlope = Add("RTL_CONE_SLOPE", MavParamType.Real32, 3);
        ReturnLoiter = Add("RTL_LOIT_TIME", MavParamType.Int32, 5000);
        LandSpeed = Add("LAND_SPEED", MavParamType.Int16, 50);
        LandSpeedHigh = Add("LAND_SPEED_HIGH", MavParamType.Int16, 0);
        LandLowHeight = Add("LAND_ALT_LOW", MavParamType.Int16, 1000);
        Add("FENCE_ENABLE", MavParamType.Int8, 0);
        GroundFailsafe = Add("FS_GCS_ENABLE", MavParamType.Int8, 0);
        GroundFailsafeTimeout = Add("FS_GCS_TIMEOUT", MavParamType.Real32, 5);
        BatteryCapacity = Add("BATT_CAPACITY", MavParamType.Int32, PackMilliampereHours);
        BatteryLowVolts = Add("BATT_LOW_VOLT", MavParamType.Real32, 10.5f);
        BatteryLowTimer = Add("BATT_LOW_TIMER", MavParamType.Int8, 10);
        BatteryLowAction = Add("BATT_FS_LOW_ACT", MavParamType.Int8, 0);
        BatteryArmVolts = Add("BATT_ARM_VOLT", MavParamType.Real32, 0);
    }

    public Parameter SystemId { get; }

    public Parameter GroundSystemId { get; }

    public Parameter ArmingCheck { get; }

    /// <summary>Seconds.</summary>
    public Parameter DisarmDelay { get; }

    /// <summary>cm/s.</summary>
    public Parameter Speed { get; }

    /// <summary>cm/s.</summary>
    public Parameter SpeedUp { get; }

    /// <summary>cm/s.</summary>
    public Parameter SpeedDown { get; }

    /// <summary>cm/s2.</summary>
    public Parameter Acceleration { get; }

    /// <summary>cm/s2.</summary>
    public Parameter VerticalAcceleration { get; }

    /// <summary>0: leave the heading alone; otherwise it follows the flight.</summary>
    public Parameter YawBehaviour { get; }

    /// <summary>Seconds.</summary>
    public Parameter GuidedTimeout { get; }

    /// <summary>cm.</summary>
    public Parameter ReturnHeight { get; }

    /// <summary>cm/s; 0: as WPNAV_SPEED.</summary>
    public Parameter ReturnSpeed { get; }

    public Parameter ReturnSlope { get; }

    /// <summary>ms.</summary>
    public Parameter ReturnLoiter { get; }

    /// <summary>cm/s.</summary>
    public Parameter LandSpeed { get; }

    /// <summary>cm/s; 0: as WPNAV_SPEED_DN.</summary>
    public Parameter LandSpeedHigh { get; }

    /// <summary>cm.</summary>
    public Parameter LandLowHeight { get; }

    public Parameter GroundFailsafe { get; }

    /// <summary>Seconds.</summary>
    public Parameter GroundFailsafeTimeout { get; }

    /// <summary>mAh.</summary>
    public Parameter BatteryCapacity { get; }

    public Parameter BatteryLowVolts { get; }

    /// <summary>Seconds.</summary>
    public Parameter BatteryLowTimer { get; }

    /// <summary>0: none, 1: land, 2: return.</summary>
    public Parameter BatteryLowAction { get; }

    /// <summary>0: not checked.</summary>
    public Parameter BatteryArmVolts { get; }

    public int Count => _all.Count;

    public Parameter this[int index] => _all[index];

    /// <summary>The index of a name; -1 where there is none.</summary>
    public int IndexOf(in Text16 name)
    {
        for (int index = 0; index < _all.Count; index++)
        {
            if (name.TextEquals(_all[index].Name))
                return index;
        }

        return -1;
    }

    /// <exception cref="ArgumentException">There is no such parameter.</exception>
    public void Set(string name, float value)
    {
        Parameter parameter = _all.Find(p => p.Name == name)
            ?? throw new ArgumentException($"The simulated autopilot has no parameter '{name}'.", nameof(name));
        parameter.Set(value);
    }

    private Parameter Add(string name, MavParamType type, float value)
    {
        var parameter = new Parameter(name, type, value);
        _all.Add(parameter);
        return parameter;
    }
}
