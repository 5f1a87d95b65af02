using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Keeps what a <see cref="FlightSummary"/> tells. The manager's thread writes, any thread takes a summary; the lock is free
/// at nearly every frame.
/// </summary>
internal sealed class FlightRecorder
{
    // Positions may come before the first heartbeat says whose matter. Nobody has more components than this on one net.
    private const int MaxSources = 64;

    private readonly object _gate = new();   // guards everything below
    private readonly BoundedLog<FlightModeChange> _modeChanges = new(FlightSummary.ListCapacity);
    private readonly BoundedLog<FlightStatusText> _statusTexts = new(FlightSummary.ListCapacity);
    private readonly BoundedLog<FlightAcknowledgement> _acknowledgements = new(FlightSummary.ListCapacity);
    private readonly Dictionary<int, PositionRanges> _ranges = [];
    private VehicleState _vehicle;
    private Heartbeat? _lastHeartbeat;
    private long _frames;
    private long _framesOfOthers;
    private long _otherAutopilots;
    private long _refused;
    private long _losses;
    private long _reboots;
    private long? _firstTime;
    private long? _lastTime;
    private RateRequestCounts _rateRequests;

    /// <summary>What became of the requests for rates. Set by the manager, read by any thread.</summary>
    public RateRequestCounts RateRequests
    {
        get
        {
            lock (_gate)
                return _rateRequests;
        }

        set
        {
            lock (_gate)
                _rateRequests = value;
        }
    }

    /// <summary>Records a frame that was folded into the state of the vehicle.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="events">What it came to.</param>
    /// <param name="vehicle">The state after it.</param>
    public void Record(in LinkFrame frame, VehicleEvents events, in VehicleState vehicle)
    {
        lock (_gate)
        {
            _frames++;
            _firstTime ??= frame.UtcMicroseconds;
            _lastTime = frame.UtcMicroseconds;
            Count(events);
            RecordContent(frame, (events & VehicleEvents.OfOther) == 0, vehicle);
        }
    }

    /// <summary>Records what the time that passed came to.</summary>
    public void Record(VehicleEvents events)
    {
        lock (_gate)
            Count(events);
    }

    public FlightSummary Summarise()
    {
        lock (_gate)
        {
            bool isKnown = _vehicle.SystemId != 0;
            PositionRanges ranges = default;
            if (isKnown)
                _ranges.TryGetValue(SourceOf(_vehicle.SystemId, _vehicle.ComponentId), out ranges);
            return new FlightSummary
            {
                Autopilot = isKnown ? _vehicle.Autopilot : null,
                VehicleType = isKnown ? _vehicle.VehicleType : null,
                SystemId = _vehicle.SystemId,
                ComponentId = _vehicle.ComponentId,
                Frames = _frames,
                FramesOfOthers = _framesOfOthers,
                HeartbeatsOfOtherAutopilots = _otherAutopilots,
                RefusedMessages = _refused,
                Losses = _losses,
                Reboots = _reboots,
                FirstUtcMicroseconds = _firstTime,
                LastUtcMicroseconds = _lastTime,
                LatitudeDegE7 = ranges.Latitude,
                LongitudeDegE7 = ranges.Longitude,
                AltitudeAmslMillimetres = ranges.AltitudeAmsl,
                HeightAboveHomeMillimetres = ranges.HeightAboveHome,
                ModeChanges = _modeChanges.ToArray(),
                ModeChangesLeftOut = _modeChanges.LeftOut,
                StatusTexts = _statusTexts.ToArray(),
                StatusTextsLeftOut = _statusTexts.LeftOut,
                Acknowledgements = _acknowledgements.ToArray(),
                AcknowledgementsLeftOut = _acknowledgements.LeftOut,
            };
        }
    }

    private void Count(VehicleEvents events)
    {
        if ((events & VehicleEvents.OfOther) != 0)
            _framesOfOthers++;
        if ((events & VehicleEvents.OtherAutopilot) != 0)
            _otherAutopilots++;
        if ((events & VehicleEvents.Refused) != 0)
            _refused++;
        if ((events & VehicleEvents.Lost) != 0)
            _losses++;
        if ((events & VehicleEvents.Rebooted) != 0)
            _reboots++;
    }

    private void RecordContent(in LinkFrame frame, bool isVehicle, in VehicleState vehicle)
    {
        MavlinkFrame mavlink = frame.Frame;
        switch (mavlink.MessageId)
        {
            case Heartbeat.MavlinkId when isVehicle:
                RecordMode(frame, mavlink, vehicle);
                break;
            case GlobalPositionInt.MavlinkId:
                RecordPosition(mavlink);
                break;
            case Statustext.MavlinkId when mavlink.TryDecode(out Statustext text):
                _statusTexts.Add(new FlightStatusText(new FlightPlace(frame), text.Severity, text.Text.ToString()));
                break;
            case CommandAck.MavlinkId when mavlink.TryDecode(out CommandAck ack):
                _acknowledgements.Add(new FlightAcknowledgement(new FlightPlace(frame), ack));
                break;
        }
    }

    private void RecordMode(in LinkFrame frame, in MavlinkFrame mavlink, in VehicleState vehicle)
    {
        mavlink.TryDecode(out Heartbeat heartbeat);
        bool isChange = _lastHeartbeat is not { } last
            || last.BaseMode != heartbeat.BaseMode
            || last.CustomMode != heartbeat.CustomMode
            || last.SystemStatus != heartbeat.SystemStatus;
        _lastHeartbeat = heartbeat;
        _vehicle = vehicle;
        if (isChange)
        {
            _modeChanges.Add(new FlightModeChange(
                new FlightPlace(frame), heartbeat.CustomMode, heartbeat.BaseMode, heartbeat.SystemStatus, vehicle.Mode!));
        }
    }

    private void RecordPosition(in MavlinkFrame mavlink)
    {
        mavlink.TryDecode(out GlobalPositionInt position);
        int source = SourceOf(mavlink.SystemId, mavlink.ComponentId);
        if (_ranges.TryGetValue(source, out PositionRanges ranges) || _ranges.Count < MaxSources)
            _ranges[source] = ranges.With(position);
    }

    private static int SourceOf(byte systemId, byte componentId) => (systemId << 8) | componentId;
}
