using System;
using System.Globalization;
using System.Threading;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace UavConsole;

/// <summary>
/// What the keys of the operator do. A key counts only where it comes alone: pasted text and the repeats of a key that
/// is held down come in bursts, and have no effect. Land and quit need a second press. It has neither a clock nor a
/// terminal: the times come with the keys.
/// </summary>
/// <param name="mission">Takes the commands; null where no mission is flown: then only quit is a key.</param>
/// <param name="quit">Stops the program in order.</param>
internal sealed class OperatorKeys(IMissionOperator? mission, Action quit) : IKeyHints
{
    private const string By = "console";
    private const int MaxTrackDigits = 5;

    // The slowest repeat of a key that is held down is 10 per second, 0.5 s after its press.
    private static readonly TimeSpan Quiet = TimeSpan.FromSeconds(0.15);
    private static readonly TimeSpan SecondPress = TimeSpan.FromSeconds(2);
    private static readonly TimeSpan NumberKept = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan AnswerShown = TimeSpan.FromSeconds(6);

    private readonly object _gate = new();
    private (char Key, TimeSpan At)? _waiting;
    private TimeSpan? _lastKey;
    private (char Key, TimeSpan At)? _first;
    private (string Digits, TimeSpan At) _number = (string.Empty, TimeSpan.Zero);
    private OperatorRequest? _request;
    private TimeSpan? _answered;
    private bool _isClosed;
    private string _line = string.Empty;

    /// <inheritdoc/>
    public string Line => Volatile.Read(ref _line);

    /// <summary>A key was pressed. Any thread.</summary>
    /// <param name="key">Its character.</param>
    /// <param name="now">When it was read.</param>
    public void Press(char key, TimeSpan now)
    {
        lock (_gate)
        {
            bool isBurst = now - _lastKey < Quiet;
            if (!isBurst)
                Settle(now);
            _lastKey = now;
            _waiting = isBurst ? null : (char.ToLowerInvariant(key), now);
        }
    }

    /// <summary>Carries out the key that came alone, and updates the line; several times a second.</summary>
    public void Update(TimeSpan now)
    {
        lock (_gate)
        {
            Settle(now);
            if (_first is { } first && now - first.At > SecondPress)
                _first = null;
            if (now - _number.At > NumberKept)
                _number.Digits = string.Empty;
            if (_request is { Outcome: not OperatorOutcome.InProgress })
                _answered ??= now;
            if (now - _answered > AnswerShown)
                (_request, _answered) = (null, null);
            Volatile.Write(ref _line, _isClosed ? string.Empty : MakeLine());
        }
    }

    /// <summary>The flight is over: keys have no effect any more.</summary>
    public void Close()
    {
        lock (_gate)
        {
            _isClosed = true;
            Volatile.Write(ref _line, string.Empty);
        }
    }

    private void Settle(TimeSpan now)
    {
        if (_waiting is not { } waiting || now - waiting.At < Quiet)
            return;
        _waiting = null;
        if (!_isClosed)
            Do(waiting.Key, waiting.At);
    }

    private void Do(char key, TimeSpan at)
    {
        if (key is 'q' or 'l' && (key == 'q' || mission is not null))
        {
            Confirm(key, at);
            return;
        }

        _first = null;
        if (mission is null)
            return;
        if (key is >= '0' and <= '9')
        {
            _number = (_number.Digits.Length < MaxTrackDigits ? _number.Digits + key : key.ToString(), at);
            return;
        }

        OperatorRequest? request = Give(mission, key);
        _number.Digits = string.Empty;
        if (request is not null)
            (_request, _answered) = (request, null);
    }

    private void Confirm(char key, TimeSpan at)
    {
        if (_first is not { } first || first.Key != key || at - first.At > SecondPress)
        {
            _first = (key, at);
            return;
        }

        _first = null;
        if (key == 'q')
            quit();
        else
            (_request, _answered) = (mission!.Land(By, "key l"), null);
    }

    private OperatorRequest? Give(IMissionOperator to, char key)
    {
        string why = "key " + key;
        bool hasTrack = int.TryParse(_number.Digits, NumberStyles.None, CultureInfo.InvariantCulture, out int track);
        return key switch
        {
            'r' => to.ReturnToLaunch(By, why),
            'h' => to.Hold(By, why),
            'c' => to.ContinueMission(By, why),
            's' => to.SkipLane(By, why),
            'v' when hasTrack => to.Revisit(track, By, why),
            'y' when hasTrack => to.Confirm(track, By, why),
            'n' when hasTrack => to.Reject(track, By, why),
            _ => null,
        };
    }

    private string MakeLine()
    {
        if (_first is { } first)
            return $"{first.Key} again within 2 s: {(first.Key == 'q' ? "quit" : "land here")}";
        if (_number.Digits.Length > 0)
            return $"track {_number.Digits}: v revisit  y is a target  n is none";
        string keys = mission is null
            ? "qq quit"
            : "r return  h hold  c continue  s skip lane  0-9 track  ll land  qq quit";
        return _request is null ? keys : AnswerOf(_request) + " | " + keys;
    }

    private static string AnswerOf(OperatorRequest request) => request.Outcome switch
    {
        OperatorOutcome.Accepted => request.Name + " accepted",
        OperatorOutcome.Refused => $"{request.Name} refused: {request.Answer}",
        _ => request.Name + " ...",
    };
}
