using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Parameters by the names that PX4 1.14 gives them, in its units, with the values that a simulated PX4 had when its
/// list was recorded. Sorted by name, as PX4 sends them.
/// </summary>
internal sealed class Px4Parameters
{
    private readonly List<Px4Parameter> _all = [];

    public Px4Parameters()
    {
        CriticalBattery = Real("BAT_CRIT_THR", 0.07);
        EmergencyBattery = Real("BAT_EMERGEN_THR", 0.05);
        LowBattery = Real("BAT_LOW_THR", 0.15);
        MaxLoad = Real("COM_CPU_MAX", -1);
        DisarmLanded = Real("COM_DISARM_LAND", 2);
        DisarmPreflight = Real("COM_DISARM_PRFLT", 10);
        GroundStationLossTime = Whole("COM_DL_LOSS_T", 10);
        FailsafeDelay = Real("COM_FAIL_ACT_T", 5);
        LowBatteryAction = Whole("COM_LOW_BAT_ACT", 0);
        OffboardLossAction = Whole("COM_OBL_RC_ACT", 0);
        OffboardLossTime = Real("COM_OF_LOSS_T", 0.5);
        ManualLossExceptions = Whole("COM_RCL_EXCEPT", 0);
        ManualInput = Whole("COM_RC_IN_MODE", 1);
        ManualLossTime = Real("COM_RC_LOSS_T", 0.5);
        StickOverride = Whole("COM_RC_OVERRIDE", 1);
        StickOverrideSpeed = Real("COM_RC_STICK_OV", 30);
        FenceAction = Whole("GF_ACTION", 2);
        FenceDistance = Real("GF_MAX_HOR_DIST", 0);
        FenceHeight = Real("GF_MAX_VER_DIST", 0);
        SystemId = Whole("MAV_SYS_ID", 1);
        Whole("MAV_TYPE", 2);
        TakeoffHeight = Real("MIS_TAKEOFF_ALT", 2.5);
        Acceleration = Real("MPC_ACC_HOR", 3);
        MaxAcceleration = Real("MPC_ACC_HOR_MAX", 5);
        LandSpeed = Real("MPC_LAND_SPEED", 0.7);
        TakeoffSpeed = Real("MPC_TKO_SPEED", 1.5);
        ManualSpeed = Real("MPC_VEL_MANUAL", 10);
        CruiseSpeed = Real("MPC_XY_CRUISE", 6.5);
        PositionGain = Real("MPC_XY_P", 0.95);
        MaxSpeed = Real("MPC_XY_VEL_MAX", 12);
        HeightGain = Real("MPC_Z_P", 1);
        MaxSpeedDown = Real("MPC_Z_VEL_MAX_DN", 1.5);
        MaxSpeedUp = Real("MPC_Z_VEL_MAX_UP", 3);
        AutoSpeedDown = Real("MPC_Z_V_AUTO_DN", 1.5);
        AutoSpeedUp = Real("MPC_Z_V_AUTO_UP", 3);
        GroundStationLossAction = Whole("NAV_DLL_ACT", 0);
        ManualLossAction = Whole("NAV_RCL_ACT", 2);
        ReturnCone = Whole("RTL_CONE_ANG", 45);
        DescendHeight = Real("RTL_DESCEND_ALT", 12);
        LandDelay = Real("RTL_LAND_DELAY", 0);
        ReturnMinDistance = Real("RTL_MIN_DIST", 10);
        ReturnHeight = Real("RTL_RETURN_ALT", 20);
        Satellites = Whole("SIM_GPS_USED", 10);
    }

    /// <summary>0 to 1.</summary>
    public Px4Parameter CriticalBattery { get; }

    /// <summary>0 to 1.</summary>
    public Px4Parameter EmergencyBattery { get; }

    /// <summary>0 to 1.</summary>
    public Px4Parameter LowBattery { get; }

    /// <summary>Per cent above which it does not arm; -1: not checked.</summary>
    public Px4Parameter MaxLoad { get; }

    /// <summary>Seconds.</summary>
    public Px4Parameter DisarmLanded { get; }

    /// <summary>Seconds.</summary>
    public Px4Parameter DisarmPreflight { get; }

    /// <summary>Seconds.</summary>
    public Px4Parameter GroundStationLossTime { get; }

    /// <summary>Seconds in AUTO.LOITER before the action of a failsafe.</summary>
    public Px4Parameter FailsafeDelay { get; }

    /// <summary>0: warning, 2: land, 3: return when critical, land in an emergency.</summary>
    public Px4Parameter LowBatteryAction { get; }

    /// <summary>0: POSCTL, 1: ALTCTL, 3: return, 4: land, 5: hold.</summary>
    public Px4Parameter OffboardLossAction { get; }

    /// <summary>Seconds.</summary>
    public Px4Parameter OffboardLossTime { get; }

    /// <summary>Bits: 1 mission, 2 hold, 4 offboard.</summary>
    public Px4Parameter ManualLossExceptions { get; }

    /// <summary>0: only a radio, 4: nothing; MANUAL_CONTROL counts in the others.</summary>
    public Px4Parameter ManualInput { get; }

    /// <summary>Seconds.</summary>
    public Px4Parameter ManualLossTime { get; }

    /// <summary>Bits: 1 in AUTO modes, 2 in OFFBOARD.</summary>
    public Px4Parameter StickOverride { get; }

    /// <summary>Per cent a second.</summary>
    public Px4Parameter StickOverrideSpeed { get; }

    /// <summary>0: none, 1: warning, 2: hold, 3: return, 5: land.</summary>
    public Px4Parameter FenceAction { get; }

    /// <summary>Metres from home; 0: not checked.</summary>
    public Px4Parameter FenceDistance { get; }

    /// <summary>Metres above home; 0: not checked.</summary>
    public Px4Parameter FenceHeight { get; }

    public Px4Parameter SystemId { get; }

    /// <summary>MAV_SYS_ID as an id.</summary>
    public byte OwnSystemId => (byte)NedMath.Limited(SystemId.Value, 1, byte.MaxValue);

    /// <summary>Metres above the ground.</summary>
    public Px4Parameter TakeoffHeight { get; }

    /// <summary>m/s2, in AUTO modes.</summary>
    public Px4Parameter Acceleration { get; }

    /// <summary>m/s2.</summary>
    public Px4Parameter MaxAcceleration { get; }

    /// <summary>m/s.</summary>
    public Px4Parameter LandSpeed { get; }

    /// <summary>m/s.</summary>
    public Px4Parameter TakeoffSpeed { get; }

    /// <summary>m/s.</summary>
    public Px4Parameter ManualSpeed { get; }

    /// <summary>m/s.</summary>
    public Px4Parameter CruiseSpeed { get; }

    /// <summary>1/s.</summary>
    public Px4Parameter PositionGain { get; }

    /// <summary>m/s.</summary>
    public Px4Parameter MaxSpeed { get; }

    /// <summary>1/s.</summary>
    public Px4Parameter HeightGain { get; }

    /// <summary>m/s.</summary>
    public Px4Parameter MaxSpeedDown { get; }

    /// <summary>m/s.</summary>
    public Px4Parameter MaxSpeedUp { get; }

    /// <summary>m/s.</summary>
    public Px4Parameter AutoSpeedDown { get; }

    /// <summary>m/s.</summary>
    public Px4Parameter AutoSpeedUp { get; }

    /// <summary>0: none, 1: hold, 2: return, 3: land.</summary>
    public Px4Parameter GroundStationLossAction { get; }

    /// <summary>0: none, 1: hold, 2: return, 3: land.</summary>
    public Px4Parameter ManualLossAction { get; }

    /// <summary>Degrees; 0: it always climbs to RTL_RETURN_ALT.</summary>
    public Px4Parameter ReturnCone { get; }

    /// <summary>Metres above home.</summary>
    public Px4Parameter DescendHeight { get; }

    /// <summary>Seconds; -1: it stays above home.</summary>
    public Px4Parameter LandDelay { get; }

    /// <summary>Metres: nearer than this it returns at the height for the descent.</summary>
    public Px4Parameter ReturnMinDistance { get; }

    /// <summary>Metres above home.</summary>
    public Px4Parameter ReturnHeight { get; }

    /// <summary>How many satellites the simulated GPS uses: below 4 it has no position.</summary>
    public Px4Parameter Satellites { get; }

    public int Count => _all.Count;

    public Px4Parameter this[int index] => _all[index];

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

    public bool Contains(string name) => _all.Exists(p => p.Name == name);

    /// <summary>Sets one that is there.</summary>
    public void Set(string name, double value) => _all.Find(p => p.Name == name)!.Set(value);

    private Px4Parameter Whole(string name, int value) => Add(new Px4Parameter(name, isWhole: true, value));

    private Px4Parameter Real(string name, double value) => Add(new Px4Parameter(name, isWhole: false, value));

    private Px4Parameter Add(Px4Parameter parameter)
    {
        _all.Add(parameter);
        return parameter;
    }
}
