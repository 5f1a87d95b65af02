using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Builds a <see cref="TelemetryRecord"/> frame by frame. Not thread-safe: <see cref="RecordKeeper"/> guards it.
/// </summary>
internal sealed class TelemetryRecorder
{
    // Frames may come before it is known which autopilot is the vehicle's. More components than this are not expected
    // on one network.
    private const int MaxSources = 64;

    private readonly BoundedLog<FlightStatusText> _statusTexts = new(TelemetryRecord.ListCapacity);
    private readonly BoundedLog<FlightAcknowledgement> _acknowledgements = new(TelemetryRecord.ListCapacity);
    private readonly Dictionary<int, SourceRecord> _sources = [];
    private int _vehicle;   // source; 0 before the first heartbeat of the autopilot
    private long _frames;
    private long? _firstTime;
    private long? _lastTime;

    /// <summary>
    /// Sets the address of the vehicle's autopilot, from which on other sources are recorded no more; nothing for 0.
    /// </summary>
    public void SetVehicle(byte systemId, byte componentId) => _vehicle = SourceOf(systemId, componentId);

    public void Record(in LinkFrame frame)
    {
        _frames++;
        _firstTime ??= frame.UtcMicroseconds;
        _lastTime = frame.UtcMicroseconds;
        MavlinkFrame mavlink = frame.Frame;
        switch (mavlink.MessageId)
        {
            case Heartbeat.MavlinkId when mavlink.TryDecode(out Heartbeat heartbeat):
                Source(mavlink)?.Record(frame, heartbeat);
                break;
            case GlobalPositionInt.MavlinkId when mavlink.TryDecode(out GlobalPositionInt position):
                Source(mavlink)?.Record(position);
                break;
            case AutopilotVersion.MavlinkId when mavlink.TryDecode(out AutopilotVersion version):
                Source(mavlink)?.Record(version);
                break;
            case Statustext.MavlinkId when mavlink.TryDecode(out Statustext text):
                _statusTexts.Add(new FlightStatusText(new FlightPlace(frame), text.Severity, text.Text.ToString()));
                break;
            case CommandAck.MavlinkId when mavlink.TryDecode(out CommandAck ack):
                _acknowledgements.Add(new FlightAcknowledgement(new FlightPlace(frame), ack));
                break;
        }
    }

    /// <param name="framesDropped">Frames that had no room in the recorder's queue.</param>
    public TelemetryRecord ToRecord(long framesDropped)
    {
        _sources.TryGetValue(_vehicle, out SourceRecord? vehicle);
        return new TelemetryRecord
        {
            Autopilot = vehicle?.LastHeartbeat?.Autopilot,
            VehicleType = vehicle?.LastHeartbeat?.Type,
            Firmware = vehicle?.Firmware,
            SystemId = (byte)(_vehicle >> 8),
            ComponentId = (byte)_vehicle,
            Frames = _frames,
            FramesDropped = framesDropped,
            FirstUtcMicroseconds = _firstTime,
            LastUtcMicroseconds = _lastTime,
            LatitudeDegE7 = vehicle?.Ranges.Latitude,
            LongitudeDegE7 = vehicle?.Ranges.Longitude,
            AltitudeAmslMillimetres = vehicle?.Ranges.AltitudeAmsl,
            HeightAboveHomeMillimetres = vehicle?.Ranges.HeightAboveHome,
            ModeChanges = vehicle?.ModeChanges.ToArray() ?? [],
            ModeChangesLeftOut = vehicle?.ModeChanges.LeftOut ?? 0,
            StatusTexts = _statusTexts.ToArray(),
            StatusTextsLeftOut = _statusTexts.LeftOut,
            Acknowledgements = _acknowledgements.ToArray(),
            AcknowledgementsLeftOut = _acknowledgements.LeftOut,
        };
    }

    // Null for a source that is not recorded.
    private SourceRecord? Source(in MavlinkFrame frame)
    {
        int source = SourceOf(frame.SystemId, frame.ComponentId);
        if (_vehicle != 0 && source != _vehicle)
            return null;
        if (!_sources.TryGetValue(source, out SourceRecord? known)
            && (_sources.Count < MaxSources || source == _vehicle))
            _sources.Add(source, known = new SourceRecord());
        return known;
    }

    private static int SourceOf(byte systemId, byte componentId) => (systemId << 8) | componentId;
}
