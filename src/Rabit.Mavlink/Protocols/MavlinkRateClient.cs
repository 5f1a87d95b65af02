using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// Requests message rates from one component (MAV_CMD_SET_MESSAGE_INTERVAL, one message after another), measures the
/// rates at which they arrive, and requests again where these are off: a ground station may have changed them. No I/O,
/// no clock: frames in, frames out, time as argument. One thread; nothing is allocated per frame.
/// </summary>
/// <remarks>
/// An acknowledgement does not name the message it is for, and waiting until no late one can arrive would take a second
/// per message. So an answer counts for the last request, a late one perhaps for the wrong message; the measured rate
/// is what counts.
/// </remarks>
/// <example>
/// <code>
/// var sender = new MavlinkSender(systemId: 1, componentId: 191);
/// var rates = new MavlinkRateClient(
///     sender, new MavlinkAddress(1, 1), [(Attitude.MavlinkId, 20), (GlobalPositionInt.MavlinkId, 5)]);
///
/// // For every frame that arrives: rates.Handle(frame, now). After that, and at rates.NextDue at the latest:
/// static void Step(MavlinkRateClient rates, TimeSpan now, Stream link, byte[] buffer)
/// {
///     while (rates.TryTakeFrame(now, out MavlinkFrame frame))
///         link.Write(buffer, 0, frame.WriteTo(buffer));
///     for (int i = 0; i &lt; rates.Count; i++)
///         Console.WriteLine($"{rates[i].MessageId}: {rates[i].MeasuredHertz:F1} of {rates[i].WantedHertz} Hz");
/// }
/// </code>
/// </example>
public sealed class MavlinkRateClient
{
    /// <summary>How long one try waits for an answer.</summary>
    public static readonly TimeSpan AnswerTimeout = TimeSpan.OfSeconds(0.7);

    /// <summary>Over how long a rate is measured.</summary>
    public static readonly TimeSpan Window = TimeSpan.FromSeconds(5);

    /// <summary>How long after a request the same message is not requested again, whatever its rate.</summary>
    public static readonly TimeSpan RepeatAfter = TimeSpan.FromSeconds(30);

    /// <summary>By which share the measured rate must be off to be requested again.</summary>
    public const double Tolerance = 0.2;

    /// <summary>How often a message is requested without an answer before the next one is.</summary>
    public const int MaxTries = 3;

    /// <summary>How often, at most, a message is requested again because of its rate.</summary>
    public const int MaxRepeats = 3;

    private readonly MavlinkSender _sender;
    private readonly MavlinkAddress _own;
    private readonly MavlinkAddress _target;
    private readonly Entry[] _entries;
    private int _current = -1;
    private int _tries;
    private TimeSpan _due;
    private TimeSpan? _windowStart;

    /// <summary>Makes a client, which sends requests from the first call of <see cref="TryTakeFrame"/> on.</summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures.</param>
    /// <param name="target">The component that sends the messages.</param>
    /// <param name="wanted">Message ids and rates, hertz; 0 turns a message off.</param>
    /// <exception cref="ArgumentNullException">No sender.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A rate is negative or no number.</exception>
    public MavlinkRateClient(
        MavlinkSender sender, MavlinkAddress target, ReadOnlySpan<(int MessageId, double Hertz)> wanted)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        _own = new MavlinkAddress(sender.SystemId, sender.ComponentId);
        _target = target;
        _entries = new Entry[wanted.Length];
        for (int i = 0; i < _entries.Length; i++)
        {
            if (!(wanted[i].Hertz >= 0 && wanted[i].Hertz <= 1e6))
                throw new ArgumentOutOfRangeException(
                    nameof(wanted), wanted[i].Hertz,
                    $"The rate of message {wanted[i].MessageId} is 0 to 1 000 000 Hz.");
            _entries[i].MessageId = wanted[i].MessageId;
            _entries[i].Hertz = wanted[i].Hertz;
        }

        Restart();
    }

    /// <summary>How many messages are wanted.</summary>
    public int Count => _entries.Length;

    /// <summary>Requests sent since the client was made, every try counted.</summary>
    public long Requests { get; private set; }

    /// <summary>When to call <see cref="TryTakeFrame"/> at the latest.</summary>
    public TimeSpan NextDue
    {
        get
        {
            TimeSpan window = _windowStart is { } start ? start + Window : TimeSpan.Zero;
            return _current >= 0 && _due < window ? _due : window;
        }
    }

    /// <summary>One of the wanted messages.</summary>
    /// <param name="index">0 to <see cref="Count"/> - 1, as given.</param>
    /// <returns>Its wanted and measured rate, and the answer.</returns>
    public MavlinkStreamRate this[int index]
    {
        get
        {
            ref Entry entry = ref _entries[index];
            return new MavlinkStreamRate(entry.MessageId, entry.Hertz, entry.Measured, entry.Answer, entry.Requests);
        }
    }

    /// <summary>Starts over: after a reboot, for example, the vehicle has lost what was requested.</summary>
    public void Restart()
    {
        _current = -1;
        _windowStart = null;
        for (int i = 0; i < _entries.Length; i++)
        {
            ref Entry entry = ref _entries[i];
            entry = new Entry
            {
                MessageId = entry.MessageId,
                Hertz = entry.Hertz,
                Measured = double.NaN,
                IsWaiting = true
            };
        }
    }

    /// <summary>Handles a received frame: every frame, since it counts them.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (!_target.IsSourceOf(frame))
            return;
        CountFrame(frame.MessageId);
        if (_current >= 0 && frame.TryDecode(out CommandAck answer))
            HandleAnswer(answer, now);
    }

    /// <summary>Takes an acknowledgement that came in, where its frame was decoded before.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="answer">Its message.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    public void Handle(in MavlinkFrame frame, in CommandAck answer, TimeSpan now)
    {
        if (!_target.IsSourceOf(frame))
            return;
        CountFrame(frame.MessageId);
        if (_current >= 0)
            HandleAnswer(answer, now);
    }

    private void CountFrame(int messageId)
    {
        for (int i = 0; i < _entries.Length; i++)
        {
            if (_entries[i].MessageId == messageId)
                _entries[i].InWindow++;
        }
    }

    private void HandleAnswer(in CommandAck answer, TimeSpan now)
    {
        if (answer.Command == MavCmd.SetMessageInterval && _own.IsTargetOf(answer.TargetSystem, answer.TargetComponent))
            HandleAnswer(answer.Result, now);
    }

    /// <summary>Takes the next frame to send. Call it until there is none.</summary>
    /// <param name="now">The time.</param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        frame = default;
        Measure(now);
        if (_current >= 0 && now < _due)
            return false;
        if (_current >= 0 && _tries >= MaxTries)
            Finish(MavlinkRateAnswer.Unanswered);
        if (_current < 0)
        {
            _current = NextWaiting();
            _tries = 0;
        }

        if (_current < 0)
            return false;
        ref Entry entry = ref _entries[_current];
        frame = _sender.Create(new CommandLong
        {
            TargetSystem = _target.SystemId,
            TargetComponent = _target.ComponentId,
            Command = MavCmd.SetMessageInterval,
            Confirmation = (byte)_tries,
            Param1 = entry.MessageId,
            Param2 = entry.Hertz > 0 ? (float)Math.Round(1e6 / entry.Hertz) : -1,
        });
        entry.Requests++;
        Requests++;
        entry.RequestedAt = now;
        _tries++;
        _due = now + AnswerTimeout;
        return true;
    }

    /// <summary>
    /// Takes the next message that was answered, or given up, since the last call. Call it until there is none; not
    /// calling it costs nothing.
    /// </summary>
    /// <param name="rate">The message with its answer.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeAnswer(out MavlinkStreamRate rate)
    {
        for (int i = 0; i < _entries.Length; i++)
        {
            if (!_entries[i].IsAnswerPending)
                continue;
            _entries[i].IsAnswerPending = false;
            rate = this[i];
            return true;
        }

        rate = default;
        return false;
    }

    private void HandleAnswer(MavResult result, TimeSpan now)
    {
        switch (result)
        {
            case MavResult.Accepted:
                Finish(MavlinkRateAnswer.Accepted);
                return;
            case MavResult.InProgress:
                _due = now + AnswerTimeout;
                return;
            case MavResult.TemporarilyRejected:
                return;   // requested again after the time-out
            default:
                Finish(MavlinkRateAnswer.Refused);
                return;
        }
    }

    private void Finish(MavlinkRateAnswer answer)
    {
        _entries[_current].Answer = answer;
        _entries[_current].IsWaiting = false;
        _entries[_current].IsAnswerPending = true;
        _current = -1;
    }

    private int NextWaiting()
    {
        for (int i = 0; i < _entries.Length; i++)
        {
            if (_entries[i].IsWaiting)
                return i;
        }

        return -1;
    }

    private void Measure(TimeSpan now)
    {
        if (_windowStart is { } start && now < start + Window)
            return;
        for (int i = 0; i < _entries.Length; i++)
        {
            ref Entry entry = ref _entries[i];

            // A window in which it was requested has both rates in it.
            if (_windowStart is { } from && entry.Requests > 0 && entry.RequestedAt < from)
                entry.Measured = entry.InWindow / (now - from).ExactSeconds;
            entry.InWindow = 0;
            bool isOff = this[i].IsOffBy(Tolerance) && entry.Answer != MavlinkRateAnswer.Refused
                && entry.Repeats < MaxRepeats;
            if (!isOff || entry.IsWaiting || now < entry.RequestedAt + RepeatAfter)
                continue;
            entry.Repeats++;
            entry.IsWaiting = true;
        }

        _windowStart = now;
    }

    private struct Entry
    {
        public int MessageId;
        public double Hertz;
        public double Measured;
        public MavlinkRateAnswer Answer;
        public int Requests;
        public int Repeats;
        public TimeSpan RequestedAt;
        public long InWindow;
        public bool IsWaiting;
        public bool IsAnswerPending;
    }
}
