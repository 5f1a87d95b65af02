using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>
/// Counts frames by message and source, and the gaps of each source. One thread counts, any thread may ask: a lock
/// guards all of it. Allocates only for a message or source that is new.
/// </summary>
/// <param name="dialect">Names the messages.</param>
/// <param name="isWire">
/// Whether what is at the other end is one device: an autopilot there is no router that keeps frames of its own.
/// </param>
internal sealed class FrameStatistics(MavlinkDialect dialect, bool isWire = false)
{
    // A hostile stream may make up as many sources and ids as it likes, unknown ids most easily of all: those may not
    // take the places of frames that were checked. What does not fit is counted together.
    private const int MaxUncheckedKinds = 1024;
    private const int MaxKinds = 8192;

    // MAV_COMP_ID_AUTOPILOT1.
    private const byte AutopilotComponent = 1;

    private readonly object _gate = new();
    private readonly Dictionary<long, long> _counts = [];
    private readonly MavlinkSequenceTracker _sequences = new();
    private long _missing;
    private int _uncheckedKinds;
    private long _frames;
    private long _notListed;

    /// <summary>Frames of kinds for which there was no room in the list.</summary>
    public long NotListed
    {
        get
        {
            lock (_gate)
                return _notListed;
        }
    }

    public long Frames
    {
        get
        {
            lock (_gate)
                return _frames;
        }
    }

    /// <summary>
    /// Frames that never came, of senders whose frames nothing in between may keep: a router passes on what is
    /// addressed to others only to them (MAVLink guide, "Packet loss").
    /// </summary>
    public long Missing
    {
        get
        {
            lock (_gate)
                return _missing;
        }
    }

    public void Count(in MavlinkFrame frame, bool isChecked)
    {
        lock (_gate)
        {
            _frames++;
            if (isChecked)
                Track(frame);
            long key = KeyOf(frame);
            if (_counts.TryGetValue(key, out long count))
                _counts[key] = count + 1;
            else if (HasRoom(isChecked))
                Add(key, isChecked);
            else
                _notListed++;
        }
    }

    public IReadOnlyList<FrameCount> Counts()
    {
        lock (_gate)
            return _counts.OrderBy(c => c.Key).Select(c => ToCount(c.Key, c.Value)).ToArray();
    }

    public IReadOnlyList<MavlinkSequenceStatistics> Sources()
    {
        lock (_gate)
            return Enumerable.Range(0, _sequences.Count).Select(i => _sequences[i])
                .OrderBy(s => (s.SystemId << 8) | s.ComponentId).ToArray();
    }

    private void Track(in MavlinkFrame frame)
    {
        _sequences.TryGet(frame.SystemId, frame.ComponentId, out MavlinkSequenceStatistics before);
        _sequences.Track(frame);
        _sequences.TryGet(frame.SystemId, frame.ComponentId, out MavlinkSequenceStatistics now);
        bool isDirect = _sequences.Count == 1 || (isWire && frame.ComponentId == AutopilotComponent);
        if (isDirect)
            _missing += now.Missing - before.Missing;
    }

    private bool HasRoom(bool isChecked)
        => _counts.Count < MaxKinds && (isChecked || _uncheckedKinds < MaxUncheckedKinds);

    private void Add(long key, bool isChecked)
    {
        _counts.Add(key, 1);
        if (!isChecked)
            _uncheckedKinds++;
    }

    // Source, then message id, then version: the order in which people read them.
    private static long KeyOf(in MavlinkFrame frame)
        => ((long)frame.SystemId << 40) | ((long)frame.ComponentId << 32) | ((long)frame.MessageId << 2)
            | (uint)frame.Version;

    private FrameCount ToCount(long key, long count)
    {
        int messageId = (int)(key >> 2) & 0xFF_FFFF;
        string? name = dialect.TryGetMessage(messageId, out MavlinkMessageInfo message) ? message.Name : null;
        return new FrameCount(messageId, name, (byte)(key >> 40), (byte)(key >> 32), (MavlinkVersion)(key & 3), count);
    }
}
