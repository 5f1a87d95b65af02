using System;
using System.Collections.Generic;
using System.Globalization;
using System.Threading;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Web.State;

/// <summary>
/// The last commands that came by the page, and what became of them. Threads of browsers give, the page writes.
/// </summary>
internal sealed class CommandDesk(string prefix, IMissionOperator? missionOperator, Func<TimeSpan> now)
{
    private const int Kept = 8;

    private readonly Lock _gate = new();   // guards all below
    private readonly Queue<Given> _given = new();
    private long _count;

    /// <summary>Whether anything can be commanded.</summary>
    public bool IsOpen => missionOperator is not null;

    /// <summary>Gives a command; it returns at once.</summary>
    public void Give(OperatorRequest request)
    {
        lock (_gate)
        {
            missionOperator!.Give(request);
            _given.Enqueue(new Given(_count++, now(), request));
            if (_given.Count > Kept)
                _given.Dequeue();
        }
    }

    public void Write(ItemWriter writer)
    {
        Given[] given;
        lock (_gate)
            given = [.. _given];
        foreach (Given one in given)
        {
            writer.Object(string.Create(CultureInfo.InvariantCulture, $"{prefix}/command/{one.Number % Kept}"))
                .Count("n", one.Number + 1).Number("t", one.At.TotalSeconds, 1).Text("name", one.Request.Name, 80)
                .Text("by", one.Request.By, 60).Text("outcome", one.Request.Outcome.ToString())
                .Text("answer", one.Request.Answer).End();
        }
    }

    private sealed record Given(long Number, TimeSpan At, OperatorRequest Request);
}
