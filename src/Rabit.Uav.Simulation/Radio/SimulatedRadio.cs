using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Mavlink;

namespace Rabit.Uav.Simulation;

/// <summary>
/// A radio between several stations: what one sends, all others may receive. It moves frames only in
/// <see cref="Exchange"/>, between the steps of what is connected to it, so that what happens does not depend on the
/// order in which the stations run. One thread.
/// </summary>
internal sealed class SimulatedRadio
{
    private const int LinkCapacity = 64 * 1024;

    // What waits longer for the radio to be free is dropped by the sender.
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(1);

    private readonly SimulatedRadioOptions _options;
    private readonly SimulationRandom _random;
    private readonly List<Station> _stations = [];
    private readonly Dictionary<(int From, int To), Burst> _bursts = [];
    private readonly SortedDictionary<(TimeSpan Due, long Number), (int From, int To, byte[] Bytes)> _onTheWay = [];
    private readonly byte[] _buffer = new byte[4096];
    private TimeSpan _busyUntil;
    private long _number;

    public SimulatedRadio(SimulatedRadioOptions options, long seed)
        => (_options, _random) = (options, new SimulationRandom(seed, "radio"));

    /// <summary>Adds a station.</summary>
    /// <param name="place">Where it is at the present time, in the frame of the group.</param>
    /// <returns>Its link.</returns>
    public IByteLink Add(Func<NedPosition> place)
    {
        var links = new MemoryLinkPair(FormattableString.Invariant($"radio {_stations.Count + 1}"), LinkCapacity);
        _stations.Add(new Station(links.B, place));
        return links.A;
    }

    public RadioCounters CountersOf(int station) => _stations[station].Counters;

    /// <summary>The radio of a station has failed, or is off: it neither sends nor receives.</summary>
    public void SwitchOff(int station) => _stations[station].IsOff = true;

    public void SwitchOn(int station) => _stations[station].IsOff = false;

    /// <summary>Takes what was sent in the last step, and delivers what has arrived.</summary>
    /// <param name="now">The end of the step.</param>
    public void Exchange(TimeSpan now)
    {
        for (int from = 0; from < _stations.Count; from++)
        {
            while (_stations[from].TryTake(_buffer, out MavlinkFrame frame))
                Send(from, frame, now);
        }

        while (_onTheWay.Count > 0 && _onTheWay.First() is var next && next.Key.Due <= now)
        {
            _onTheWay.Remove(next.Key);
            (int from, int to, byte[] bytes) = next.Value;
            if (_stations[to].IsOff)
            {
                _stations[from].Counters.LostByPartition++;
                continue;
            }

            _stations[to].Link.Write(bytes, 0, bytes.Length);
            _stations[from].Counters.Delivered++;
        }
    }

    private void Send(int from, in MavlinkFrame frame, TimeSpan now)
    {
        Station station = _stations[from];
        int length = frame.WriteTo(_buffer);
        TimeSpan begin = _busyUntil > now ? _busyUntil : now;
        if (station.IsOff || begin - now > MaxWait)
        {
            station.Counters.FramesRefused++;
            return;
        }

        _busyUntil = begin + TimeSpan.OfSeconds((double)length / _options.BytesPerSecond);
        station.Counters.FramesSent++;
        station.Counters.BytesSent += length;
        byte[] bytes = _buffer.AsSpan(0, length).ToArray();
        for (int to = 0; to < _stations.Count; to++)
        {
            if (to == from || IsLost(from, to, now))
                continue;
            Deliver(from, to, bytes);
            if (_random.Uniform() >= _options.DuplicateFraction)
                continue;
            Deliver(from, to, bytes);
            station.Counters.Duplicated++;
        }
    }

    private void Deliver(int from, int to, byte[] bytes)
    {
        double jitter = -Math.Log(1 - _random.Uniform()) * _options.Jitter.ExactSeconds;
        TimeSpan due = _busyUntil + _options.Latency + TimeSpan.OfSeconds(jitter);
        _onTheWay.Add((due, _number++), (from, to, bytes));
    }

    private bool IsLost(int from, int to, TimeSpan now)
    {
        ref RadioCounters counters = ref _stations[from].Counters;
        if (_stations[to].IsOff || _options.Partitions.Any(p => p.Separates(from, to, now)))
        {
            counters.LostByPartition++;
            return true;
        }

        if (IsInBurst(from, to, now))
        {
            counters.LostInBursts++;
            return true;
        }

        double distance = _stations[from].Place().DistanceTo(_stations[to].Place());
        double far = 1 / (1 + Math.Exp((_options.HalfLossMetres - distance) / _options.LossSlopeMetres));
        if (_random.Uniform() >= 1 - ((1 - _options.Loss) * (1 - far)))
            return false;
        counters.LostAtRandom++;
        return true;
    }

    private bool IsInBurst(int from, int to, TimeSpan now)
    {
        if (_options.BurstsPerSecond <= 0)
            return false;
        (int, int) pair = (Math.Min(from, to), Math.Max(from, to));
        if (!_bursts.TryGetValue(pair, out Burst? burst))
            _bursts.Add(pair, burst = new Burst(_random, _options));
        return burst.IsOn(now);
    }

    private sealed class Station(IByteLink link, Func<NedPosition> place)
    {
        private readonly MavlinkFrameReader _reader = new(MavlinkDialect.All);
        private int _start;
        private int _count;
        private byte[] _rest = [];

        public RadioCounters Counters;

        public IByteLink Link { get; } = link;

        public Func<NedPosition> Place { get; } = place;

        public bool IsOff { get; set; }

        // Senders write whole frames, so that nothing is held back for long.
        public bool TryTake(byte[] buffer, out MavlinkFrame frame)
        {
            while (true)
            {
                var rest = new ReadOnlySpan<byte>(_rest, _start, _count);
                bool isTaken = _reader.TryRead(ref rest, out frame, out _);
                _start += _count - rest.Length;
                _count = rest.Length;
                if (isTaken)
                    return true;
                LinkRead read = Link.Read(buffer);
                if (read.Kind != LinkReadKind.Bytes)
                    return false;
                (_rest, _start, _count) = (buffer.AsSpan(0, read.Count).ToArray(), 0, read.Count);
            }
        }
    }

    // Gilbert and Elliott: good and bad times, both exponential.
    private sealed class Burst(SimulationRandom random, SimulatedRadioOptions options)
    {
        private bool _isOn;
        private TimeSpan _until = TimeSpan.Zero;

        public bool IsOn(TimeSpan now)
        {
            while (_until <= now)
            {
                _isOn = _until > TimeSpan.Zero && !_isOn;
                double mean = _isOn ? options.BurstDuration.ExactSeconds : 1 / options.BurstsPerSecond;
                _until += TimeSpan.OfSeconds(Math.Max(1e-3, -Math.Log(1 - random.Uniform()) * mean));
            }

            return _isOn;
        }
    }
}
