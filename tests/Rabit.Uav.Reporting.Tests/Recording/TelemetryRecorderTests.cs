using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

public class TelemetryRecorderTests
{
    private const MavModeFlag Armed = MavModeFlag.CustomModeEnabled | MavModeFlag.SafetyArmed;

    private readonly TelemetryRecorder _recorder = new();
    private long _index;

    [Fact]
    public void ToRecord_Nothing_IsEmpty()
    {
        TelemetryRecord flight = ToRecord();
        Assert.Null(flight.Autopilot);
        Assert.Null(flight.VehicleType);
        Assert.Null(flight.FirstUtcMicroseconds);
        Assert.Null(flight.LatitudeDegE7);
        Assert.Empty(flight.ModeChanges);
        Assert.Equal(0, flight.Frames);
    }

    [Fact]
    public void ToRecord_PositionsBeforeTheFirstHeartbeat_CountForTheVehicleAlone()
    {
        Record(new GlobalPositionInt { Lat = 10, Lon = 20, Alt = 30, RelativeAlt = 40 });
        Record(new GlobalPositionInt { Lat = 1000, Lon = 1000, Alt = 1000, RelativeAlt = 1000 }, system: 2);
        Record(Copter());
        Record(new GlobalPositionInt { Lat = -10, Lon = 25, Alt = 0, RelativeAlt = -1 });

        TelemetryRecord flight = ToRecord();
        Assert.Equal((-10, 10), Pair(flight.LatitudeDegE7));
        Assert.Equal((20, 25), Pair(flight.LongitudeDegE7));
        Assert.Equal((0, 30), Pair(flight.AltitudeAmslMillimetres));
        Assert.Equal((-1, 40), Pair(flight.HeightAboveHomeMillimetres));
    }

    [Theory]
    [InlineData(0x040507FFu, "4.5.7")]
    [InlineData(0x040600C0u, "4.6.0 release candidate")]
    [InlineData(0x010F0080u, "1.15.0 beta")]
    [InlineData(0x010F0040u, "1.15.0 alpha")]
    [InlineData(0x01100000u, "1.16.0 development")]
    [InlineData(0u, null)]
    public void Firmware_VersionOfTheVehicle_IsThatOfItsFlightSoftware(uint version, string? expected)
    {
        Record(Copter());
        Record(new AutopilotVersion { FlightSwVersion = version });
        Record(new AutopilotVersion { FlightSwVersion = 0x09090900 }, system: 2);

        Assert.Equal(expected, ToRecord().Firmware);
    }

    [Fact]
    public void ModeChanges_EveryChangeOfModeFlagsOrStatus_IsAnEntry()
    {
        Record(Copter());
        Record(Copter());
        Record(Copter(CopterMode.Guided));
        Record(Copter(CopterMode.Guided, Armed));
        Record(Copter(CopterMode.Guided, Armed, MavState.Active));
        Record(Copter(CopterMode.Rtl), system: 2);
        Record(Copter(CopterMode.Guided, Armed, MavState.Active));

        Assert.Equal(
            ["0 STABILIZE False Standby", "2 GUIDED False Standby", "3 GUIDED True Standby", "4 GUIDED True Active"],
            System.Linq.Enumerable.Select(
                ToRecord().ModeChanges, c => $"{c.Record} {c.Mode} {c.IsArmed} {c.SystemStatus}"));
    }

    [Fact]
    public void ModeChanges_BeforeTheVehicleIsKnown_AreThoseOfTheVehicleAlone()
    {
        Record(Copter(CopterMode.Rtl), system: 2);
        Record(Copter(CopterMode.Guided), system: 3);
        Record(new Heartbeat { Type = MavType.Gimbal, Autopilot = MavAutopilot.Invalid }, system: 3);

        FlightModeChange change = Assert.Single(ToRecord(vehicle: 3).ModeChanges);
        Assert.Equal((1L, "GUIDED"), (change.Record, change.Mode));
        Assert.Equal(MavType.Quadrotor, ToRecord(vehicle: 3).VehicleType);
    }

    [Fact]
    public void Lists_TooMany_AreBoundedAndTheRestIsCounted()
    {
        const int Extra = 7;
        for (int i = 0; i < TelemetryRecord.ListCapacity + Extra; i++)
        {
            Record(Copter((CopterMode)(i % 2)));
            Record(new Statustext { Text = new Text50("a") });
            Record(new CommandAck());
        }

        TelemetryRecord flight = ToRecord();
        Assert.Equal(TelemetryRecord.ListCapacity, flight.ModeChanges.Count);
        Assert.Equal(TelemetryRecord.ListCapacity, flight.StatusTexts.Count);
        Assert.Equal(TelemetryRecord.ListCapacity, flight.Acknowledgements.Count);
        Assert.Equal(
            (Extra, Extra, Extra),
            (flight.ModeChangesLeftOut, flight.StatusTextsLeftOut, flight.AcknowledgementsLeftOut));
        Assert.Equal(3 * (TelemetryRecord.ListCapacity + Extra), flight.Frames);
    }

    [Fact]
    public void StatusTextsAndAcknowledgements_OfAnySource_AreKept()
    {
        Record(new Statustext { Text = new Text50("early") }, system: 7);
        Record(Copter());
        Record(new Statustext { Text = new Text50("of the vehicle") });
        Record(new CommandAck { Command = MavCmd.NavLand }, system: 7);

        Assert.Equal(
            [(7, "early"), (1, "of the vehicle")],
            System.Linq.Enumerable.Select(ToRecord().StatusTexts, t => ((int)t.SystemId, t.Text)));
        Assert.Equal(7, Assert.Single(ToRecord().Acknowledgements).SystemId);
    }

    [Fact]
    public void Record_FramesWithoutAnEntry_AllocatesNothing()
    {
        Record(Copter());
        LinkFrame[] frames =
        [
            new() { Frame = MavlinkFrame.Create(Copter(), 1, 1, 0) },
            new() { Frame = MavlinkFrame.Create(new GlobalPositionInt { Lat = 1, Lon = 1 }, 1, 1, 0) },
            new() { Frame = MavlinkFrame.Create(new Attitude { Roll = 1 }, 1, 1, 0) },
        ];
        void RecordAll()
        {
            foreach (LinkFrame frame in frames)
                _recorder.Record(frame);
        }

        RecordAll();
        Assert.Equal(0, Allocated.By(RecordAll));
    }

    [Fact]
    public void ToRecord_Snapshot_DoesNotChangeAfterwards()
    {
        Record(Copter());
        TelemetryRecord before = ToRecord();
        Record(Copter(CopterMode.Rtl));
        Assert.Single(before.ModeChanges);
        Assert.Equal(2, ToRecord().ModeChanges.Count);
    }

    private void Record<T>(in T message, byte system = 1)
        where T : struct, IMavlinkMessage
    {
        _recorder.Record(new LinkFrame
        {
            Frame = MavlinkFrame.Create(message, system, 1, (byte)_index),
            Index = _index,
            UtcMicroseconds = 1_700_000_000_000_000 + _index,
        });
        _index++;
    }

    // As when Autopilot Interface has found the vehicle by then.
    private TelemetryRecord ToRecord(byte vehicle = 1)
    {
        _recorder.SetVehicle(_index == 0 ? (byte)0 : vehicle, _index == 0 ? (byte)0 : (byte)1);
        return _recorder.ToRecord(framesDropped: 0);
    }

    private static Heartbeat Copter(
        CopterMode mode = CopterMode.Stabilize, MavModeFlag flags = MavModeFlag.CustomModeEnabled,
        MavState status = MavState.Standby)
            => new()
            {
                Type = MavType.Quadrotor,
                Autopilot = MavAutopilot.Ardupilotmega,
                BaseMode = flags,
                CustomMode = (uint)mode,
                SystemStatus = status,
                MavlinkVersion = 3,
            };

    private static (int Minimum, int Maximum) Pair(FlightRange? range) => (range!.Value.Minimum, range.Value.Maximum);
}
