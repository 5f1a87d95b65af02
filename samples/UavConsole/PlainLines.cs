using System;
using System.Linq;
using System.Threading.Tasks;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>The view for pipes, files and services: a line when something changes, and one every few seconds.</summary>
internal sealed class PlainLines(FlightMonitor monitor, RunLog log)
{
    private static readonly TimeSpan LookEvery = TimeSpan.FromMilliseconds(100);
    private const int LooksPerLine = 50;

    private string? _lastHealth;
    private StatusText? _lastText;

    public void ShowUntilEnd(Task run)
    {
        for (int look = 1; !run.Wait(LookEvery); look++)
        {
            monitor.Refresh();
            ShowNews();
            if (look % LooksPerLine == 0)
                Console.WriteLine(Text.StatusLine(monitor));
        }

        monitor.Refresh();
        ShowNews();
    }

    private void ShowNews()
    {
        foreach (RabitLogEntry entry in log.TakeAll())
            Console.WriteLine(entry);

        string health = Text.Health(monitor.Health);
        if (health != _lastHealth)
            Console.WriteLine(Text.At(monitor.Now) + "health: " + health);
        _lastHealth = health;

        foreach (StatusText text in monitor.Texts.TakeWhile(t => t != _lastText).Reverse())
            Console.WriteLine(Text.At(text.Time) + Text.Of(text));
        _lastText = monitor.Texts.FirstOrDefault();
    }
}
