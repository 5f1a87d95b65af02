using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.Web.Collecting;

namespace Rabit.Uav.Web.State;

/// <summary>The links with their state and how much goes over them.</summary>
internal sealed class LinkItems(string prefix)
{
    private const int MaxLinks = 32;

    private static readonly TimeSpan Window = TimeSpan.FromSeconds(2);

    private Rate[] _rates = [];
    private IReadOnlyList<LinkStatus>? _last;

    public void Write(ItemWriter writer, FlightMoment moment)
    {
        if (ReferenceEquals(moment.Links, _last))
            return;
        _last = moment.Links;
        if (_rates.Length == 0)
            _rates = [.. Enumerable.Range(0, Math.Min(MaxLinks, _last.Count)).Select(_ => new Rate())];
        for (int link = 0; link < _rates.Length; link++)
            Write(writer, link, _last[link], moment.Time);
    }

    private void Write(ItemWriter writer, int link, LinkStatus status, TimeSpan now)
    {
        Rate rate = _rates[link];
        rate.Take(now, status.FramesIn, status.FramesOut);
        writer.Object(string.Create(CultureInfo.InvariantCulture, $"{prefix}/link/{link}"))
            .Text("name", status.Name ?? status.Url, 80).Text("state", status.State.ToString())
            .Flag("optional", status.IsOptional).Text("fault", status.Fault)
            .Number("in", rate.In, 1).Number("out", rate.Out, 1)
            .Count("missing", status.FramesMissing).Count("lost", status.BytesLost)
            .Count("dropped", status.FramesDroppedIn + status.FramesDroppedOut)
            .Number(
                "roundTrip", status.Budget.RoundTripSeconds > 0 ? status.Budget.RoundTripSeconds * 1000 : double.NaN, 0)
            .Number("budget", status.Budget.BytesPerSecond > 0 ? status.Budget.BytesPerSecond : double.NaN, 0)
            .Number("progress", status.Progress * 100, 0).End();
    }

    // Frames per second over the last seconds.
    private sealed class Rate
    {
        private (TimeSpan Time, long In, long Out)? _from;

        public double In { get; private set; } = double.NaN;

        public double Out { get; private set; } = double.NaN;

        public void Take(TimeSpan now, long framesIn, long framesOut)
        {
            _from ??= (now, framesIn, framesOut);
            TimeSpan passed = now - _from.Value.Time;
            if (passed < Window)
                return;
            In = (framesIn - _from.Value.In) / passed.TotalSeconds;
            Out = (framesOut - _from.Value.Out) / passed.TotalSeconds;
            _from = (now, framesIn, framesOut);
        }
    }
}
