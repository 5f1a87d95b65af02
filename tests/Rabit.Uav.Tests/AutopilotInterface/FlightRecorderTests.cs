using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

public class FlightRecorderTests
{
    private readonly VehicleTracker _tracker = new(null, TimeSpan.FromSeconds(5));
    private readonly FlightRecorder _recorder = new();
    private long _index;

    [Fact]
    public void Summarise_Nothing_IsEmpty()
    {
        FlightSummary flight = _recorder.Summarise();
        Assert.Null(flight.Autopilot);
        Assert.Null(flight.VehicleType);
        Assert.Null(flight.FirstUtcMicroseconds);
        Assert.Null(flight.LatitudeDegE7);
        Assert.Empty(flight.ModeChanges);
        Assert.Equal(0, flight.Frames);
    }

    [Fact]
    public void Summarise_PositionsBeforeTheFirstHeartbeat_CountForTheVehicleAlone()
    {
        Record(new GlobalPositionInt { Lat = 10, Lon = 20, Alt = 30, RelativeAlt = 40 });
        Record(new GlobalPositionInt { Lat = 1000, Lon = 1000, Alt = 1000, RelativeAlt = 1000 }, system: 2);
        Record(AutopilotRig.Copter());
        Record(new GlobalPositionInt { Lat = -10, Lon = 25, Alt = 0, RelativeAlt = -1 });

        FlightSummary flight = _recorder.Summarise();
        Assert.Equal((-10, 10), Pair(flight.LatitudeDegE7));
        Assert.Equal((20, 25), Pair(flight.LongitudeDegE7));
        Assert.Equal((0, 30), Pair(flight.AltitudeAmslMillimetres));
        Assert.Equal((-1, 40), Pair(flight.HeightAboveHomeMillimetres));
    }

    [Fact]
    public void ModeChanges_EveryChangeOfModeFlagsOrStatus_IsAnEntry()
    {
        Record(AutopilotRig.Copter());
        Record(AutopilotRig.Copter());
        Record(AutopilotRig.Copter(CopterMode.Guided));
        Record(AutopilotRig.Copter(CopterMode.Guided, AutopilotRig.Armed));
        Record(AutopilotRig.Copter(CopterMode.Guided, AutopilotRig.Armed, MavState.Active));
        Record(AutopilotRig.Copter(CopterMode.Rtl), system: 2);
        Record(AutopilotRig.Copter(CopterMode.Guided, AutopilotRig.Armed, MavState.Active));

        Assert.Equal(
            ["0 STABILIZE False Standby", "2 GUIDED False Standby", "3 GUIDED True Standby", "4 GUIDED True Active"],
            System.Linq.Enumerable.Select(_recorder.Summarise().ModeChanges, c => $"{c.Record} {c.Mode} {c.IsArmed} {c.SystemStatus}"));
    }

    [Fact]
    public void Lists_TooMany_AreBoundedAndTheRestIsCounted()
    {
        const int Extra = 7;
        for (int i = 0; i < FlightSummary.ListCapacity + Extra; i++)
        {
            Record(AutopilotRig.Copter((CopterMode)(i % 2)));
            Record(new Statustext { Text = new Text50("a") });
            Record(new CommandAck());
        }

        FlightSummary flight = _recorder.Summarise();
        Assert.Equal(FlightSummary.ListCapacity, flight.ModeChanges.Count);
        Assert.Equal(FlightSummary.ListCapacity, flight.StatusTexts.Count);
        Assert.Equal(FlightSummary.ListCapacity, flight.Acknowledgements.Count);
        Assert.Equal((Extra, Extra, Extra), (flight.ModeChangesLeftOut, flight.StatusTextsLeftOut, flight.AcknowledgementsLeftOut));
        Assert.Equal(3 * (FlightSummary.ListCapacity + Extra), flight.Frames);
    }

    [Fact]
    public void Summarise_Snapshot_DoesNotChangeAfterwards()
    {
        Record(AutopilotRig.Copter());
        FlightSummary before = _recorder.Summarise();
        Record(AutopilotRig.Copter(CopterMode.Rtl));
        Assert.Single(before.ModeChanges);
        Assert.Equal(2, _recorder.Summarise().ModeChanges.Count);
    }

    private void Record<T>(in T message, byte system = 1)
        where T : struct, Mavlink.IMavlinkMessage
    {
        LinkFrame frame = AutopilotRig.FrameOf(message, TimeSpan.FromMilliseconds(_index), system, index: _index);
        _index++;
        _recorder.Record(frame, _tracker.UpdateBy(frame), _tracker.State);
    }

    private static (int Minimum, int Maximum) Pair(FlightRange? range) => (range!.Value.Minimum, range.Value.Maximum);
}
