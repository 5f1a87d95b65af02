using System;
using System.Linq;
using System.Threading.Tasks;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;

namespace UavConsole;

/// <summary>The view for pipes, files and services: a line when something changes, and one every few seconds.</summary>
internal sealed class PlainLines(FlightMonitor monitor, RunLog log, bool showsMission = false)
{
    private static readonly TimeSpan RefreshPeriod = TimeSpan.FromMilliseconds(100);
    private const int RefreshesPerLine = 50;

    private readonly PreflightPrinter _preflight = new(Console.WriteLine);
    private HealthReport _lastHealth;
    private StatusText? _lastText;

    public void ShowUntilEnd(Task run)
    {
        for (int refresh = 1; !run.Wait(RefreshPeriod); refresh++)
        {
            monitor.Refresh();
            bool isTimeForALine = refresh % RefreshesPerLine == 0;
            ShowNews(withFigures: isTimeForALine);
            if (isTimeForALine)
                Console.WriteLine(
                    Text.StatusLine(monitor) + (showsMission ? "; " + Text.Mission(monitor) : string.Empty));
        }

        monitor.Refresh();
        ShowNews(withFigures: true);
    }

    /// <param name="withFigures">
    /// Also where only a figure in the health report has changed, which some do all the time.
    /// </param>
    private void ShowNews(bool withFigures)
    {
        foreach (string line in log.TakeAll())
            Console.WriteLine(line);
        _preflight.Show(monitor.Preflight);

        HealthReport health = monitor.Health;
        if (health.Level != _lastHealth.Level || health.Reasons != _lastHealth.Reasons
            || (withFigures && health.Text != _lastHealth.Text))
        {
            Console.WriteLine(FlightText.TimeStamp(monitor.Now) + "health: " + FlightText.Health(health));
            _lastHealth = health;
        }

        foreach (StatusText text in monitor.Texts.TakeWhile(t => t != _lastText).Reverse())
            Console.WriteLine(FlightText.TimeStamp(text.Time) + Text.Of(text));
        _lastText = monitor.Texts.FirstOrDefault();
    }
}
