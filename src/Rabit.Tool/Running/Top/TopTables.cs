using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Tool.Running.Top;

/// <summary>Makes tables of samples; remembers the sample before, for what woke the managers since.</summary>
internal sealed class TopTables
{
    private const int MaxNameLength = 40;
    private const int WakeUpWidth = 24;   // two causes with their rates

    private static readonly TopColumn[] ManagerColumns =
    [
        new("MANAGER", Rank: 0, IsNumber: false), new("state", Rank: 1, IsNumber: false, MinWidth: 8),
        new("runs/s", Rank: 1), new("load %", Rank: 1),
        new("woken by, 1/s", Rank: 3, IsNumber: false, MinWidth: WakeUpWidth), new("wake p50 ms", Rank: 6),
        new("wake p99 ms", Rank: 2), new("work p50 ms", Rank: 6), new("work p99 ms", Rank: 4), new("missed", Rank: 1),
        new("late", Rank: 7), new("faults", Rank: 2), new("restarts", Rank: 7), new("hangs", Rank: 5),
    ];

    private static readonly TopColumn[] QueueColumns =
    [
        new("QUEUE", Rank: 0, IsNumber: false), new("type", Rank: 3, IsNumber: false), new("level", Rank: 0),
        new("high water", Rank: 2), new("capacity", Rank: 1), new("pushes/s", Rank: 1), new("dropped", Rank: 1),
        new("rejected", Rank: 1),
    ];

    private static readonly TopColumn[] MessageColumns =
    [
        new("MESSAGE", Rank: 0, IsNumber: false), new("type", Rank: 3, IsNumber: false), new("posts/s", Rank: 1),
        new("age s", Rank: 1), new("posts", Rank: 2, MinWidth: 8),
    ];

    private Dictionary<string, WakeUpFigures> _lastWakeUps = [];

    public IReadOnlyList<TopTable> Make(SampleLine sample)
    {
        bool isOne = sample.Reactors.Count == 1;
        var wakeUps = new Dictionary<string, WakeUpFigures>(StringComparer.Ordinal);
        var managers = new List<TopRow>();
        var queues = new List<TopRow>();
        var messages = new List<TopRow>();
        foreach (ReactorFigures reactor in sample.Reactors)
        {
            string prefix = isOne ? string.Empty : reactor.Name + ": ";
            foreach (ManagerFigures manager in reactor.Managers)
            {
                string name = prefix + manager.Name;
                wakeUps[name] = manager.WakeUps;
                managers.Add(RowOf(name, manager, _lastWakeUps.GetValueOrDefault(name)));
            }

            queues.AddRange(reactor.Queues.Select(q => RowOf(prefix + q.Name, q)));
            messages.AddRange(reactor.Messages.Select(m => RowOf(prefix + m.Name, m)));
        }

        _lastWakeUps = wakeUps;
        return
        [
            new TopTable(TopSection.Managers, ManagerColumns, managers),
            new TopTable(TopSection.Queues, QueueColumns, queues),
            new TopTable(TopSection.Messages, MessageColumns, messages),
        ];
    }

    private static TopRow RowOf(string name, ManagerFigures manager, WakeUpFigures? before) => new(name,
    [
        Shorten(name),
        new TopCell(PlainText.Of(manager.State), IsWarning: manager.State is "hanging" or "faulted" or "restarting"),
        TopText.Rate(manager.RunsPerSecond),
        TopText.Percent(manager.Load),
        WakeUpText.Of(manager, before),
        TopText.Milliseconds(manager.WakeLatency.P50Seconds),
        TopText.Milliseconds(manager.WakeLatency.P99Seconds),
        TopText.Milliseconds(manager.UnitOfWork.P50Seconds),
        TopText.Milliseconds(manager.UnitOfWork.P99Seconds),
        Warning(manager.MissedDeadlines),
        Warning(manager.LateUnitsOfWork),
        Warning(manager.Faults),
        Warning(manager.Restarts),
        Warning(manager.Hangs),
    ])
    {
        Rate = manager.RunsPerSecond ?? 0,
        Load = manager.Load ?? 0,
        Trouble = manager.MissedDeadlines + manager.LateUnitsOfWork
            + (1e6 * (manager.Faults + manager.Hangs)) + (manager.State is "hanging" or "faulted" ? 1e12 : 0),
    };

    private static TopRow RowOf(string name, QueueFigures queue) => new(name,
    [
        Shorten(name),
        Shorten(queue.ValueType),
        new TopCell(TopText.Count(queue.Level), IsWarning: queue.Level >= queue.Capacity),
        TopText.Count(queue.HighWater),
        TopText.Count(queue.Capacity),
        TopText.Rate(queue.PushesPerSecond),
        Warning(queue.Dropped),
        Warning(queue.Rejected),
    ])
    {
        Rate = queue.PushesPerSecond ?? 0,
        Load = queue.Capacity == 0 ? 0 : (double)queue.Level / queue.Capacity,
        Trouble = queue.Dropped + queue.Rejected,
    };

    private static TopRow RowOf(string name, MessageFigures message) => new(name,
    [
        Shorten(name),
        Shorten(message.ValueType),
        TopText.Rate(message.PostsPerSecond),
        TopText.Seconds(message.AgeSeconds),
        TopText.Count(message.Posts),
    ])
    {
        Rate = message.PostsPerSecond ?? 0,
        Load = -(message.AgeSeconds ?? double.MaxValue),
        Trouble = message.AgeSeconds ?? -1,
    };

    private static TopCell Warning(long count) => new(TopText.Count(count), IsWarning: count > 0);

    private static string Shorten(string name)
    {
        string text = PlainText.Of(name);
        return text.Length <= MaxNameLength ? text : text[..(MaxNameLength - 2)] + "..";
    }
}
