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
    private const double CentimetresPerMetre = 100;

    private const int SwitchPositions = 6;

    private readonly List<Parameter> _all = [];
    private readonly List<Parameter> _flightModes = [];
    private readonly double _returnHeightPerMetre;

    /// <param name="hasNewerNames">See <see cref="SimulationOptions.HasNewerParameterNames"/>.</param>
    public ParameterStore(bool hasNewerNames = false)
    {
        SystemId = Add(hasNewerNames ? "MAV_SYSID" : "SYSID_THISMAV", MavParamType.Int16, 1);
        GroundSystemId = Add(hasNewerNames ? "MAV_GCS_SYSID" : "SYSID_MYGCS", MavParamType.Int16, 255);
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
        _returnHeightPerMetre = hasNewerNames ? 1 : CentimetresPerMetre;
        ReturnHeight = hasNewerNames
            ? Add("RTL_ALT_M", MavParamType.Real32, 15)
            : Add("RTL_ALT", MavParamType.Int32, 1500);
        ReturnSpeed = Add("RTL_SPEED", MavParamType.Int16, 0);
        ReturnSlope = Add("RTL_CONE_SLOPE", MavParamType.Real32, 3);
        ReturnLoiter = Add("RTL_LOIT_TIME", MavParamType.Int32, 5000);
        LandSpeed = Add("LAND_SPEED", MavParamType.Int16, 50);
        LandSpeedHigh = Add("LAND_SPEED_HIGH", MavParamType.Int16, 0);
        LandLowHeight = Add("LAND_ALT_LOW", MavParamType.Int16, 1000);
        GroundFailsafe = Add("FS_GCS_ENABLE", MavParamType.Int8, 0);
        GroundFailsafeTimeout = Add("FS_GCS_TIMEOUT", MavParamType.Real32, 5);
        RadioFailsafe = Add("FS_THR_ENABLE", MavParamType.Int8, 1);
        FailsafeOptions = Add("FS_OPTIONS", MavParamType.Int32, 16);
        EstimatorFailsafe = Add("FS_EKF_ACTION", MavParamType.Int8, 1);
        EstimatorThreshold = Add("FS_EKF_THRESH", MavParamType.Real32, 0.8f);
        Add("FLTMODE_CH", MavParamType.Int8, 5);
        for (int position = 1; position <= SwitchPositions; position++)
            _flightModes.Add(Add(FormattableString.Invariant($"FLTMODE{position}"), MavParamType.Int8, 0));
        Battery = new BatteryParameters(Add);
        Fence = new FenceParameters(Add);
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

    /// <summary>cm, or m by its newer name: see <see cref="ReturnHeightMetres"/>.</summary>
    public Parameter ReturnHeight { get; }

    public double ReturnHeightMetres => ReturnHeight.Value / _returnHeightPerMetre;

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

    /// <summary>0: off; 1: return; 3: land; more: see <see cref="FailsafeResponse"/>.</summary>
    public Parameter RadioFailsafe { get; }

    /// <summary>Bits; see <see cref="FailsafeResponse"/>.</summary>
    public Parameter FailsafeOptions { get; }

    /// <summary>0: report only, 1: land, 2: hold the height, 3: land, in modes without a position too.</summary>
    public Parameter EstimatorFailsafe { get; }

    /// <summary>0: the estimator is not checked.</summary>
    public Parameter EstimatorThreshold { get; }

    public BatteryParameters Battery { get; }

    public FenceParameters Fence { get; }

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

    /// <summary>FLTMODE1 to FLTMODE6, by the position of the mode switch from 0 on.</summary>
    public int FlightModeAt(int position) => (int)_flightModes[position].Value;

    public bool Contains(string name) => _all.Exists(p => p.Name == name);

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
