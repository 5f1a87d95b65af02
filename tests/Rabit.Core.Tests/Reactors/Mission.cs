using System;
using System.Security.Cryptography;
using System.Text;
using Rabit.Core.Tests.Contracts;

namespace Rabit.Core.Tests.Reactors;

/// <summary>
/// Six managers at 50 Hz that post, fetch, push and pop, with a scripted reader: something for virtual time to repeat.
/// </summary>
internal sealed class Mission : IDisposable
{
    private const int Managers = 6;
    private readonly SHA256 _hash = SHA256.Create();
    private readonly StringBuilder _text = new();
    private readonly RabitReactor _reactor;

    public Mission(RabitTime time)
    {
        _reactor = new RabitReactor(
            new ReactorOptions { Time = time, Log = Write, LogRuns = true, StopsOnSignals = false });
        for (int i = 0; i < Managers; i++)
            _reactor.Add(new Member(i));
    }

    public long Lines { get; private set; }

    /// <summary>Runs it, and returns what its log amounts to.</summary>
    /// <returns>SHA-256 of the log, and of what each manager computed.</returns>
    public string Run(TimeSpan duration, int steps = 1)
    {
        _reactor.Start();
        for (int step = 0; step < steps; step++)
            _reactor.RunFor(
                TimeSpan.FromTicks((duration.Ticks * (step + 1) / steps) - (duration.Ticks * step / steps)));
        _reactor.Stop("landed");
        ReactorResult result = _reactor.Finish();
        _text.Append(result).Append('\n');
        foreach (RabitManager manager in _reactor)
            _text.Append(((Member)manager).Sum).Append('\n');
        Flush();
        _hash.TransformFinalBlock([], 0, 0);
        return BitConverter.ToString(_hash.Hash!);
    }

    public void Dispose() => _hash.Dispose();

    private void Write(RabitLogEntry entry)
    {
        Lines++;
        _text.Append(entry.Time.Ticks).Append(' ').Append(entry.Source).Append(' ').Append(entry.Text).Append('\n');
        if (_text.Length > 100_000)
            Flush();
    }

    private void Flush()
    {
        byte[] bytes = Encoding.UTF8.GetBytes(_text.ToString());
        _hash.TransformBlock(bytes, 0, bytes.Length, null, 0);
        _text.Clear();
    }

    private struct State
    {
        public long Sum;
        public TimeSpan At;
    }

    private sealed class Member : RabitManager
    {
        private readonly MessagePublisher<State> _own;
        private readonly MessageSubscriber<State> _neighbour;
        private readonly QueueReceiver<long> _inbox;
        private readonly QueueSender<long> _outbox;
        private readonly BlockingReader<int>? _reader;

        public Member(int number)
            : base("member " + number)
        {
            _own = Publish<State>("state " + number);
            _neighbour = Subscribe<State>("state " + ((number + 1) % Managers), wakeOnPost: number == 0);
            _inbox = Receive<long>("inbox " + number, 5, QueueFullMode.DropOldest, wakeOnPush: number == 1);
            _outbox = Send<long>("inbox " + ((number + 2) % Managers), wakeOnPop: number == 2);
            WakeUpDelay = TimeSpan.FromMilliseconds(20);
            if (number == 3)
                _reader = AttachReader(
                    "sensor", new ScriptedSource(new TestBoard(), TimeSpan.FromMilliseconds(100), new int[100]),
                    capacity: 4);
        }

        public long Sum { get; private set; }

        protected override void ExecuteUnitOfWork()
        {
            if (_neighbour.FetchAndCountMissed(out int missed))
                Sum = unchecked((Sum * 31) + _neighbour.Value.Sum + missed + _neighbour.Value.At.Ticks);
            while (_inbox.TryPop(out long value))
                Sum = unchecked((Sum * 17) + value);
            while (_reader is not null && _reader.TryPop(out int read))
                Sum = unchecked((Sum * 13) + read + 1);
            _own.Value = new State { Sum = Sum, At = Now };
            _own.Post();
            _outbox.Push(Sum);
        }
    }
}
