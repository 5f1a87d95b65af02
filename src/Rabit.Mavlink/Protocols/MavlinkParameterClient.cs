using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// Lists, reads and sets the parameters of one component (MAVLink guide, "Parameter Protocol"), one operation after
/// another, each with exactly one outcome. No I/O, no clock: frames in, frames out, time as argument. One thread;
/// nothing is allocated per frame.
/// </summary>
/// <remarks>
/// A list is streamed by the vehicle; what is missing when the stream stops is requested by index, some at a time,
/// until all are received or <see cref="MavlinkParameterOptions.EmptyRounds"/> rounds brought nothing. A set has
/// succeeded when the vehicle reports the value; a different value counts once the request was sent twice, since an
/// older report may still be in flight.
/// </remarks>
/// <example>
/// <code>
/// static void ReadAll(MavlinkParameterClient client, TimeSpan now) =&gt; client.TryStartList(now);
///
/// // For every frame that arrives: client.Handle(frame, now). After that, and at client.NextDue at the latest:
/// static void Step(MavlinkParameterClient client, TimeSpan now, Stream link, byte[] buffer)
/// {
///     while (client.TryTakeFrame(now, out MavlinkFrame frame))
///         link.Write(buffer, 0, frame.WriteTo(buffer));
///     if (!client.TryTakeOutcome(out MavlinkParameterOutcome outcome))
///         return;
///     Console.WriteLine($"{outcome.Status}, {outcome.Missing} missing");
///     for (int i = 0; i &lt; client.Parameters.Count; i++)
///         Console.WriteLine($"{client.Parameters[i].Name} = {client.Parameters[i].ToDouble(client.Encoding)}");
/// }
/// </code>
/// </example>
public sealed partial class MavlinkParameterClient
{
    // PX4 sends this in front of a list: a checksum of names and values, which a receiver that kept the list compares.
    private const string HashName = "_HASH_CHECK";

    private static readonly Text16 HashText = new(HashName);

    private readonly MavlinkSender _sender;
    private readonly MavlinkAddress _own;
    private readonly MavlinkAddress _target;
    private readonly MavlinkParameterOptions _options;
    private Operation _operation;
    private MavlinkParameterOutcome _outcome;
    private bool _hasOutcome;
    private TimeSpan _due;
    private int _tries;
    private int _sent;

    // Of a read or set.
    private Text16 _name;
    private int _index;
    private uint _wanted;
    private MavParamType _type;
    private MavlinkParameter _other;
    private int _others;
    private TimeSpan _lastSentAt = TimeSpan.MinValue;

    /// <summary>Makes a client.</summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures.</param>
    /// <param name="target">Whose parameters.</param>
    /// <param name="encoding">How the vehicle packs integers.</param>
    /// <param name="options">Time-outs and retries; null for the defaults.</param>
    /// <exception cref="ArgumentNullException">No sender.</exception>
    /// <exception cref="ArgumentException">The target is not one component.</exception>
    public MavlinkParameterClient(
        MavlinkSender sender, MavlinkAddress target, MavlinkParameterEncoding encoding,
        MavlinkParameterOptions? options = null)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        if (target.SystemId == 0 || target.ComponentId == 0)
            throw new ArgumentException("Parameters belong to one component; 0 means all.", nameof(target));
        _own = new MavlinkAddress(sender.SystemId, sender.ComponentId);
        _target = target;
        Encoding = encoding;
        _options = options ?? new MavlinkParameterOptions();
    }

    private enum Operation
    {
        None,
        List,
        Read,
        Set,
    }

    /// <summary>How the vehicle packs integers.</summary>
    public MavlinkParameterEncoding Encoding { get; }

    /// <summary>
    /// The parameters known: filled by a list, kept up to date by every PARAM_VALUE of the vehicle, whatever requested
    /// it.
    /// </summary>
    public MavlinkParameterTable Parameters { get; } = new();

    /// <summary>
    /// The last hash that the vehicle sent (PX4); null where there is none. Keep it with the list, for
    /// <see cref="TryStartList"/>.
    /// </summary>
    public uint? Hash { get; private set; }

    /// <summary>Whether an operation is under way, or its outcome not taken yet: nothing else can start.</summary>
    public bool IsBusy => _operation != Operation.None || _hasOutcome;

    /// <summary>
    /// When to call <see cref="TryTakeFrame"/> at the latest; <see cref="TimeSpan.MaxValue"/> while there is nothing to
    /// wait for.
    /// </summary>
    public TimeSpan NextDue => _operation == Operation.None && !_mustStopList ? TimeSpan.MaxValue : _due;

    /// <summary>Starts to read one parameter by its name.</summary>
    /// <param name="name">At most 16 characters.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    /// <returns>Whether it has started; false while <see cref="IsBusy"/>.</returns>
    /// <exception cref="ArgumentException">No name, or not one that fits.</exception>
    public bool TryStartRead(string name, TimeSpan now) => TryStartOne(Operation.Read, NameOf(name), -1, now);

    /// <summary>Starts to read one parameter by its index.</summary>
    /// <param name="index">0 to 32767.</param>
    /// <param name="now">The time.</param>
    /// <returns>Whether it has started; false while <see cref="IsBusy"/>.</returns>
    /// <exception cref="ArgumentOutOfRangeException">No such index.</exception>
    public bool TryStartRead(int index, TimeSpan now) => index is >= 0 and <= short.MaxValue
        ? TryStartOne(Operation.Read, default, index, now)
        : throw new ArgumentOutOfRangeException(nameof(index), index, "0 to 32767.");

    /// <summary>Starts to set a parameter.</summary>
    /// <param name="name">Its name, at most 16 characters.</param>
    /// <param name="type">Its type on the vehicle; PX4 refuses another one.</param>
    /// <param name="value">The value.</param>
    /// <param name="now">The time.</param>
    /// <returns>Whether it has started; false while <see cref="IsBusy"/>.</returns>
    /// <exception cref="ArgumentException">No name, or not one that fits.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The type or the encoding cannot hold the value.</exception>
    public bool TryStartSet(string name, MavParamType type, double value, TimeSpan now)
    {
        uint wanted = MavlinkParameter.Encode(value, type, Encoding);
        if (!TryStartOne(Operation.Set, NameOf(name), -1, now))
            return false;
        _wanted = wanted;
        _type = type;
        return true;
    }

    /// <summary>
    /// Cancels what is under way, with the outcome <see cref="MavlinkParameterStatus.Cancelled"/>. A set may have been
    /// done.
    /// </summary>
    /// <param name="now">The time.</param>
    public void Cancel(TimeSpan now)
    {
        if (_operation != Operation.None)
            End(MavlinkParameterStatus.Cancelled, default, now);
    }

    /// <summary>Takes the outcome of what was started last; it is returned once.</summary>
    /// <param name="outcome">The outcome.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeOutcome(out MavlinkParameterOutcome outcome)
    {
        outcome = _hasOutcome ? _outcome : default;
        bool had = _hasOutcome;
        _hasOutcome = false;
        return had;
    }

    /// <summary>Handles a received frame; all but PARAM_VALUE and PARAM_ERROR of the vehicle are ignored.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">The time.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (!_target.IsSourceOf(frame))
            return;
        if (frame.TryDecode(out ParamValue value))
            Take(MavlinkParameter.From(value), value.ParamCount, now);
        else if (frame.TryDecode(out ParamError error) && _own.IsTargetOf(error.TargetSystem, error.TargetComponent))
            Take(error, now);
    }

    /// <summary>Takes the next frame to send. Call it until there is none.</summary>
    /// <param name="now">The time.</param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        frame = default;
        if (TryStopList(out frame))
            return true;
        if (_operation == Operation.None || now < _due)
            return false;
        return _operation == Operation.List ? TryNextOfList(now, out frame) : TryNextTry(now, out frame);
    }

    private static Text16 NameOf(string name) => string.IsNullOrEmpty(name)
        ? throw new ArgumentException("A parameter has a name.", nameof(name))
        : new Text16(name);

    private bool TryStartOne(Operation operation, Text16 name, int index, TimeSpan now)
    {
        if (IsBusy)
            return false;

        // A late report of an earlier request must not be mistaken for the answer.
        bool isAgain = _lastSentAt != TimeSpan.MinValue && name == _name && index == _index
            && now < _lastSentAt + _options.LateAnswerTime;
        _due = isAgain ? _lastSentAt + _options.LateAnswerTime : now;
        _operation = operation;
        _name = name;
        _index = index;
        _other = default;
        _others = _tries = _sent = 0;
        return true;
    }

    private bool TryNextTry(TimeSpan now, out MavlinkFrame frame)
    {
        frame = default;
        if (_tries > _options.Retries)
        {
            End(_others > 0 ? MavlinkParameterStatus.Refused : MavlinkParameterStatus.Unknown, _other, now);
            return false;
        }

        frame = _operation == Operation.Read ? Request(_name, _index) : SetRequest(_name, _type, _wanted);
        _tries++;
        _lastSentAt = now;
        _due = now + _options.AnswerTimeout;
        return true;
    }

    private void Take(in MavlinkParameter parameter, int count, TimeSpan now)
    {
        if (parameter.Name == HashText)
        {
            TakeHash(parameter.Bits, now);
            if (_name != HashText)
                return;
        }

        if (_operation == Operation.List)
        {
            TakeListed(parameter, count, now);
            return;
        }

        Parameters.Update(parameter);
        if (_operation == Operation.None || _tries == 0
            || (_index >= 0 ? parameter.Index != _index : parameter.Name != _name))
            return;
        if (_operation == Operation.Read || IsWanted(parameter))
        {
            End(MavlinkParameterStatus.Done, parameter, now);
            return;
        }

        _other = parameter;
        _others++;
        if (_others > 1 && _tries > 1)
            End(MavlinkParameterStatus.Refused, parameter, now);
    }

    // ArduPilot answers with its own type, whatever the request said; then it is the number that counts.
    private bool IsWanted(in MavlinkParameter parameter) => parameter.Bits == _wanted
        || (parameter.Type != _type
            && parameter.ToDouble(Encoding).Equals(MavlinkParameter.Decode(_wanted, _type, Encoding)));

    private void Take(in ParamError error, TimeSpan now)
    {
        bool isOurs = _operation is Operation.Read or Operation.Set && _tries > 0
            && (_index >= 0 ? error.ParamIndex == _index : MavlinkParameter.Clean(error.ParamId) == _name);
        if (!isOurs)
            return;
        End(MavlinkParameterStatus.Refused, _other, now);
        _outcome = _outcome with { Error = error.Error };
    }

    private MavlinkFrame Request(Text16 name, int index)
    {
        _sent++;
        return _sender.Create(new ParamRequestRead
        {
            TargetSystem = _target.SystemId,
            TargetComponent = _target.ComponentId,
            ParamId = name,
            ParamIndex = (short)index,
        });
    }

    private MavlinkFrame SetRequest(Text16 name, MavParamType type, uint bits)
    {
        _sent++;
        return _sender.Create(new ParamSet
        {
            TargetSystem = _target.SystemId,
            TargetComponent = _target.ComponentId,
            ParamId = name,
            ParamType = type,
            ParamValue = MavlinkParameter.ToFloat(bits),
        });
    }

    private void End(MavlinkParameterStatus status, in MavlinkParameter parameter, TimeSpan now)
    {
        int missing = _operation != Operation.List ? 0 : _hasCount ? Parameters.Missing : -1;
        _operation = Operation.None;
        _outcome = new MavlinkParameterOutcome(status, parameter, MavParamError.NoError, missing, _sent, now);
        _hasOutcome = true;
    }
}
