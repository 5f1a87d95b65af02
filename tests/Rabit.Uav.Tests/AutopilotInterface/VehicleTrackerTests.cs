using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Tests.Shared;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.AutopilotInterface;

public class VehicleTrackerTests(ITestOutputHelper output)
{
    private static readonly TimeSpan Timeout = TimeSpan.FromSeconds(5);

    [Fact]
    public void Update_Position_IsInSiAndRadians()
    {
        VehicleTracker tracker = ConnectedTracker();
        var message = new GlobalPositionInt
        {
            Lat = -353_632_000,
            Lon = 1_491_652_300,
            Alt = 584_040,
            RelativeAlt = -33,
            Vx = 150,
            Vy = -250,
            Vz = -100,
            Hdg = 9000,
        };

        Assert.Equal(VehicleEvents.Changed, Update(tracker, message, 2));

        VehicleState state = tracker.State;
        Assert.Equal(-35.3632 * Angle.RadiansPerDegree, state.Position.Latitude.Radians, 12);
        Assert.Equal(149.16523 * Angle.RadiansPerDegree, state.Position.Longitude.Radians, 12);
        Assert.Equal(584.04, state.Position.AltitudeAmslMetres, 9);
        Assert.Equal(-0.033, state.HeightAboveHomeMetres, 9);
        Assert.Equal((1.5, -2.5, -1.0), (state.VelocityNed.North, state.VelocityNed.East, state.VelocityNed.Down));
        Assert.Equal(TimeSpan.FromSeconds(2), state.PositionTime);
        Assert.Equal(TimeSpan.FromSeconds(2), tracker.NewestTime);
    }

    [Theory]
    [InlineData(900_000_001, 0)]
    [InlineData(-900_000_001, 0)]
    [InlineData(0, 1_800_000_001)]
    [InlineData(0, -1_800_000_001)]
    [InlineData(int.MaxValue, int.MaxValue)]
    [InlineData(int.MinValue, int.MinValue)]
    [InlineData(0, 0)]
    public void Update_PlaceThatIsNone_IsRefused(int latitude, int longitude)
    {
        VehicleTracker tracker = ConnectedTracker();
        Assert.Equal(
            VehicleEvents.Refused,
            Update(tracker, new GlobalPositionInt { Lat = latitude, Lon = longitude, Alt = 1 }, 2));
        Assert.Null(tracker.State.PositionTime);
    }

    [Theory]
    [InlineData(900_000_000, 1_800_000_000)]
    [InlineData(-900_000_000, -1_800_000_000)]
    [InlineData(0, 1)]
    public void Update_PlaceAtTheLimit_IsTaken(int latitude, int longitude)
    {
        VehicleTracker tracker = ConnectedTracker();
        Assert.Equal(
            VehicleEvents.Changed, Update(tracker, new GlobalPositionInt { Lat = latitude, Lon = longitude }, 2));
    }

    [Theory]
    [InlineData(float.NaN, 0, 0, 0)]
    [InlineData(0, float.PositiveInfinity, 0, 0)]
    [InlineData(0, 0, float.NegativeInfinity, 0)]
    [InlineData(0, 0, 0, float.NaN)]
    [InlineData(7, 0, 0, 0)]
    [InlineData(0, 1.6f, 0, 0)]
    [InlineData(float.MaxValue, 0, 0, 0)]
    public void Update_AttitudeThatIsNone_IsRefused(float roll, float pitch, float yaw, float yawRate)
    {
        VehicleTracker tracker = ConnectedTracker();
        var message = new Attitude { Roll = roll, Pitch = pitch, Yaw = yaw, Yawspeed = yawRate };
        Assert.Equal(VehicleEvents.Refused, Update(tracker, message, 2));
        Assert.Null(tracker.State.AttitudeTime);
    }

    [Fact]
    public void Update_YawFromZeroToTwoPi_IsWrapped()
    {
        VehicleTracker tracker = ConnectedTracker();
        Update(
            tracker, new Attitude { Roll = 0.1f, Pitch = -0.2f, Yaw = 6, Rollspeed = 1, Pitchspeed = 2, Yawspeed = 3 },
            2);

        VehicleState state = tracker.State;
        Assert.Equal(6 - (2 * Math.PI), state.Attitude.Yaw.Radians, 6);
        Assert.Equal(0.1f, state.Attitude.Roll.Radians);
        Assert.Equal(-0.2f, state.Attitude.Pitch.Radians);
        Assert.Equal(
            (1.0, 2.0, 3.0),
            (state.Rates.RollRadiansPerSecond, state.Rates.PitchRadiansPerSecond, state.Rates.YawRadiansPerSecond));
    }

    [Theory]
    [InlineData(12_345, 1_234, 87, 12.345, 12.34, 0.87)]
    [InlineData(ushort.MaxValue, -1, -1, double.NaN, double.NaN, double.NaN)]
    [InlineData(0, -250, 0, 0, -2.5, 0)]
    [InlineData(12_000, 0, 100, 12, 0, 1)]
    [InlineData(12_000, 0, 101, 12, 0, double.NaN)]
    [InlineData(12_000, 0, -128, 12, 0, double.NaN)]
    public void Update_SysStatus_UnknownIsNotANumber(
        int millivolts, short centiamperes, sbyte percent, double volts, double amperes, double remaining)
    {
        VehicleTracker tracker = ConnectedTracker();
        Update(tracker, new SysStatus
        {
            VoltageBattery = (ushort)millivolts,
            CurrentBattery = centiamperes,
            BatteryRemaining = percent
        }, 2);
        AssertBattery(tracker, volts, amperes, remaining);
    }

    [Fact]
    public void State_BeforeAnyBattery_IsNotANumber()
        => AssertBattery(ConnectedTracker(), double.NaN, double.NaN, double.NaN);

    [Fact]
    public void Update_BatteryStatus_AddsTheCells()
    {
        VehicleTracker tracker = ConnectedTracker();
        Update(tracker, Battery(500, 55, 4_100, 4_110, 4_120), 2);
        AssertBattery(tracker, 12.33, 5, 0.55);
        Update(tracker, Battery(-1, -1), 30);
        AssertBattery(tracker, double.NaN, double.NaN, double.NaN);
    }

    [Fact]
    public void Update_BatteryStatus_TakesCellsChargeStateAndFaults()
    {
        VehicleTracker tracker = ConnectedTracker();
        BatteryStatus message = Battery(500, 55, 4_100, 4_110, 4_120, 0);
        message.ChargeState = MavBatteryChargeState.Low;
        message.FaultBitmask = MavBatteryFault.CellFail;
        Update(tracker, message, 2);
        VehicleState state = tracker.State;
        Assert.Equal(
            (3, MavBatteryChargeState.Low, MavBatteryFault.CellFail),
            (state.BatteryCells, state.BatteryChargeState, state.BatteryFaults));

        // The whole battery in the first: how many cells it has is not reported.
        Update(tracker, Battery(500, 55, 12_330), 3);
        Assert.Equal(0, tracker.State.BatteryCells);
    }

    [Theory]
    [InlineData(true, true, false, true)]
    [InlineData(true, true, true, false)]
    [InlineData(true, false, false, false)]
    [InlineData(false, true, false, false)]
    public void Update_SysStatus_BatteryIsUnhealthyWhereItIsPresentAndEnabled(
        bool isPresent, bool isEnabled, bool isHealthy, bool expected)
    {
        static MavSysStatusSensor Bit(bool isSet) => isSet ? MavSysStatusSensor.Battery : 0;
        VehicleTracker tracker = ConnectedTracker();
        Update(tracker, new SysStatus
        {
            OnboardControlSensorsPresent = Bit(isPresent),
            OnboardControlSensorsEnabled = Bit(isEnabled),
            OnboardControlSensorsHealth = Bit(isHealthy),
        }, 2);
        Assert.Equal(expected, tracker.State.IsBatteryUnhealthy);
    }

    [Fact]
    public void Update_BatteryStatusOfAnotherBattery_ChangesNothing()
    {
        VehicleTracker tracker = ConnectedTracker();
        BatteryStatus second = Battery(500, 55, 4_100);
        second.Id = 1;
        Assert.Equal(VehicleEvents.None, Update(tracker, second, 2));
        Assert.Null(tracker.State.BatteryTime);
    }

    [Fact]
    public void Update_TwoBatteryMessages_FillEachOthersGapsForAWhile()
    {
        VehicleTracker tracker = ConnectedTracker();
        Update(tracker, Battery(500, 55, 12_000), 2);
        Update(tracker, new SysStatus { VoltageBattery = 11_000, CurrentBattery = -1, BatteryRemaining = -1 }, 3);
        AssertBattery(tracker, 11, 5, 0.55);
        Update(tracker, new SysStatus { VoltageBattery = 11_000, CurrentBattery = -1, BatteryRemaining = -1 }, 13);
        AssertBattery(tracker, 11, double.NaN, double.NaN);
    }

    [Fact]
    public void Update_GpsAndTime_AreTaken()
    {
        VehicleTracker tracker = ConnectedTracker();
        Update(tracker, new GpsRawInt { FixType = GpsFixType.RtkFixed, SatellitesVisible = 17 }, 2);
        Update(tracker, new SystemTime { TimeUnixUsec = 1_795_227_296_098_321, TimeBootMs = 100 }, 3);
        Update(tracker, new ExtendedSysState { LandedState = MavLandedState.InAir }, 3);

        VehicleState state = tracker.State;
        Assert.Equal(
            (GpsFixType.RtkFixed, 17, TimeSpan.FromSeconds(2)), (state.GpsFix, state.Satellites, state.GpsTime));
        Assert.Equal((1_795_227_296_098_321, TimeSpan.FromSeconds(3)), (state.GpsUtcMicroseconds, state.UtcTime));
        Assert.Equal((MavLandedState.InAir, TimeSpan.FromSeconds(3)), (state.LandedState, state.LandedStateTime));
    }

    [Theory]
    [InlineData(GpsFixType.Type3dFix, 488_250, 1500u, 488.25, 1.5)]
    [InlineData(GpsFixType.RtkFixed, -12_000, 0u, -12.0, null)]
    [InlineData(GpsFixType.Type2dFix, 488_250, 1500u, null, null)]
    [InlineData(GpsFixType.NoFix, 488_250, 1500u, null, null)]
    [InlineData((GpsFixType)200, 488_250, 1500u, null, null)]
    [InlineData(GpsFixType.Type3dFix, int.MinValue, 1500u, null, null)]
    [InlineData(GpsFixType.Type3dFix, int.MaxValue, 1500u, null, null)]
    public void Update_AltitudeOfTheReceiver_IsTakenWhereItCanBe(
        GpsFixType fix, int millimetres, uint sigmaMillimetres, double? expected, double? sigma)
    {
        VehicleTracker tracker = ConnectedTracker();
        Update(tracker, new GpsRawInt { FixType = GpsFixType.Type3dFix, Alt = 1000, VAcc = 1 }, 1);
        Update(tracker, new GpsRawInt { FixType = fix, Alt = millimetres, VAcc = sigmaMillimetres }, 2);
        Assert.Equal(
            (expected, sigma), (tracker.State.GnssAltitudeAmslMetres, tracker.State.GnssAltitudeSigmaMetres));
    }

    // The flags that ap-gps-ekf-failsafe and px4-gps-loss record.
    [Theory]
    [InlineData(0x033F, true)]
    [InlineData(0x833F, true)]
    [InlineData(0x0025, false)]
    [InlineData(0x00A7, false)]
    [InlineData(0x0400, false)]
    public void Update_ArdupilotsEstimator_SaysWhetherThePositionIsValid(int flags, bool isValid)
    {
        VehicleTracker tracker = ConnectedTracker();
        Assert.True(tracker.State.HasValidHorizontalPosition);
        Update(tracker, new EkfStatusReport { Flags = (EkfStatusFlags)flags }, 4);

        Assert.Equal(TimeSpan.FromSeconds(4), tracker.State.EstimatorTime);
        Assert.Equal(isValid, tracker.State.HasValidHorizontalPosition);
        Assert.Equal(
            (flags & 0x8000) != 0, (tracker.State.EstimatorFlags & EstimatorStatusFlags.GpsGlitch) != 0);
    }

    [Theory]
    [InlineData(0x033F, true)]
    [InlineData(0x0025, false)]
    public void Update_Px4sEstimator_SaysWhetherThePositionIsValid(int flags, bool isValid)
    {
        VehicleTracker tracker = ConnectedTracker();
        Update(tracker, new EstimatorStatus { Flags = (EstimatorStatusFlags)flags }, 4);

        Assert.Equal((EstimatorStatusFlags)flags, tracker.State.EstimatorFlags);
        Assert.Equal(isValid, tracker.State.HasValidHorizontalPosition);
    }

    [Theory]
    [InlineData(0UL)]
    [InlineData(12_345UL)]
    [InlineData(ulong.MaxValue)]
    public void Update_TimeThatIsNotSet_IsZero(ulong microseconds)
    {
        VehicleTracker tracker = ConnectedTracker();
        Update(tracker, new SystemTime { TimeUnixUsec = microseconds }, 2);
        Assert.Equal(0, tracker.State.GpsUtcMicroseconds);
    }

    [Theory]
    [InlineData(MavType.Gcs, MavAutopilot.Generic, 1, 1)]
    [InlineData(MavType.Gcs, MavAutopilot.Invalid, 255, 190)]
    [InlineData(MavType.OnboardController, MavAutopilot.Invalid, 1, 191)]
    [InlineData(MavType.Camera, MavAutopilot.Generic, 1, 100)]
    [InlineData(MavType.Quadrotor, MavAutopilot.Invalid, 1, 1)]
    [InlineData(MavType.Quadrotor, MavAutopilot.Px4, 0, 1)]
    [InlineData(MavType.Quadrotor, MavAutopilot.Px4, 1, 0)]
    public void Update_HeartbeatOfNoAutopilot_IsNotOurs(
        MavType type, MavAutopilot autopilot, byte system, byte component)
    {
        var tracker = new VehicleTracker(null, Timeout);
        LinkFrame frame = AutopilotRig.FrameOf(
            new Heartbeat { Type = type, Autopilot = autopilot }, TimeSpan.Zero, system, component);
        Assert.Equal(VehicleEvents.OfOther, tracker.UpdateBy(frame));
        Assert.Equal(0, tracker.State.SystemId);
    }

    [Fact]
    public void Update_HostileFrames_NeverThrow()
    {
        const int Seed = 20_261_121;
        output.WriteLine($"seed {Seed}");
        var random = new Random(Seed);
        VehicleTracker tracker = ConnectedTracker();
        var payload = new byte[255];
        for (int i = 0; i < 20_000; i++)
        {
            random.NextBytes(payload);
            Assert.False(ThrowsOrLies(tracker, payload), $"round {i}");
        }
    }

    [Fact]
    public void Update_KnownMessages_AllocatesNothing()
    {
        VehicleTracker tracker = ConnectedTracker();
        LinkFrame[] frames =
        [
            AutopilotRig.FrameOf(AutopilotRig.Copter((CopterMode)99), TimeSpan.Zero),
            AutopilotRig.FrameOf(new GlobalPositionInt { Lat = 1, Lon = 1 }, TimeSpan.Zero),
            AutopilotRig.FrameOf(new Attitude { Roll = 1 }, TimeSpan.Zero),
            AutopilotRig.FrameOf(Battery(1, 2, 3), TimeSpan.Zero),
            AutopilotRig.FrameOf(new SysStatus(), TimeSpan.Zero),
            AutopilotRig.FrameOf(new SystemTime(), TimeSpan.Zero),
            AutopilotRig.FrameOf(new VfrHud(), TimeSpan.Zero),
            AutopilotRig.FrameOf(new Heartbeat { Type = MavType.Gcs }, TimeSpan.Zero, 255, 190),
        ];
        void FoldAll()
        {
            foreach (LinkFrame frame in frames)
                tracker.UpdateBy(frame);
        }

        FoldAll();
        Assert.Equal(0, Allocated.By(FoldAll));
    }

    private static bool ThrowsOrLies(VehicleTracker tracker, byte[] payload)
    {
        Update(tracker, Random<GlobalPositionInt>(payload), 1);
        Update(tracker, Random<Attitude>(payload), 1);
        Update(tracker, Random<SysStatus>(payload), 1);
        Update(tracker, Random<BatteryStatus>(payload), 1);
        Update(tracker, Random<GpsRawInt>(payload), 1);
        Update(tracker, Random<SystemTime>(payload), 1);
        Update(tracker, Random<ExtendedSysState>(payload), 1);
        Update(tracker, Random<Wind>(payload), 1);
        Update(tracker, Random<WindCov>(payload), 1);
        Update(tracker, Random<Heartbeat>(payload), 1);
        VehicleState state = tracker.State;
        return !(Math.Abs(state.Position.Latitude.Radians) <= Math.PI / 2)
            || !(Math.Abs(state.Position.Longitude.Radians) <= Math.PI)
            || !(Math.Abs(state.Attitude.Yaw.Radians) <= Math.PI)
            || !(Math.Abs(state.Attitude.Pitch.Radians) <= 1.58)
            || double.IsInfinity(state.Rates.YawRadiansPerSecond)
            || double.IsNaN(state.Rates.YawRadiansPerSecond)
            || (state.WindTime is not null && !(state.WindMetresPerSecond is > 0 and <= 113))
            || state.BatteryRemaining is < 0 or > 1;
    }

    private static T Random<T>(byte[] payload)
        where T : struct, Mavlink.IMavlinkMessage
    {
        var message = default(T);
        message.Decode(payload);
        return message;
    }

    private static VehicleTracker ConnectedTracker()
    {
        var tracker = new VehicleTracker(null, Timeout);
        Assert.Equal(VehicleEvents.Changed | VehicleEvents.Found, Update(tracker, AutopilotRig.Copter(), 1));
        return tracker;
    }

    private static VehicleEvents Update<T>(VehicleTracker tracker, in T message, double seconds)
        where T : struct, Mavlink.IMavlinkMessage
        => tracker.UpdateBy(AutopilotRig.FrameOf(message, TimeSpan.FromSeconds(seconds))) & ~VehicleEvents.Lost;

    private static BatteryStatus Battery(short centiamperes, sbyte percent, params ushort[] cells)
    {
        ushort[] all = new ushort[10];
        for (int i = 0; i < all.Length; i++)
            all[i] = i < cells.Length ? cells[i] : ushort.MaxValue;
        return new BatteryStatus
        {
            Voltages = new UInt16Array10(all),
            CurrentBattery = centiamperes,
            BatteryRemaining = percent
        };
    }

    private static void AssertBattery(VehicleTracker tracker, double volts, double amperes, double remaining)
    {
        Assert.Equal(volts, tracker.State.BatteryVolts, 9);
        Assert.Equal(amperes, tracker.State.BatteryAmperes, 9);
        Assert.Equal(remaining, tracker.State.BatteryRemaining, 9);
    }
}
