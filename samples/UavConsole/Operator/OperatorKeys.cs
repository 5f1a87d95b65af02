using System;
using System.Threading;

namespace UavConsole;

/// <summary>
/// What the keys of the operator do. A key counts only where it comes alone: pasted text and the repeats of a key that
/// is held down come in bursts, and have no effect. Land and quit need a second press. It has neither a clock nor a
/// terminal: the times come with the keys.
/// </summary>
/// <param name="commands">What the keys command; null where no mission is flown: then only quit is a key.</param>
/// <param name="quit">Stops the program in order.</param>
internal sealed class OperatorKeys(IKeyCommands? commands, Action quit) : IKeyHints
{
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
    private IKeyAnswer? _answer;
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
            if (_answer is { IsAnswered: true })
                _answered ??= now;
            if (now - _answered > AnswerShown)
                (_answer, _answered) = (null, null);
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
        if (key is 'q' or 'l' && (key == 'q' || commands is not null))
        {
            Confirm(key, at);
            return;
        }

        _first = null;
        if (commands is null)
            return;
        if (key is >= '0' and <= '9')
        {
            _number = (_number.Digits.Length < MaxTrackDigits ? _number.Digits + key : key.ToString(), at);
            return;
        }

        Show(commands.Do(key, _number.Digits));
        _number.Digits = string.Empty;
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
            Show(commands!.Do(key, string.Empty));
    }

    private void Show(IKeyAnswer? answer)
    {
        if (answer is not null)
            (_answer, _answered) = (answer, null);
    }

    private string MakeLine()
    {
        if (_first is { } first)
            return $"{first.Key} again within 2 s: {(first.Key == 'q' ? "quit" : "land here")}";
        if (_number.Digits.Length > 0)
            return $"{commands!.NumberName} {_number.Digits}: {commands.NumberHint}";
        string keys = commands?.Hint ?? "qq quit";
        return _answer is null ? keys : _answer.Text + " | " + keys;
    }
}
