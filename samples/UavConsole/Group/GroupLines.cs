using System;
using System.Threading.Tasks;
using Rabit.Uav.Reporting;

namespace UavConsole;

/// <summary>The view of a group for pipes and files: the log, and a line for each vehicle every few seconds.</summary>
internal sealed class GroupLines(GroupFlight flight)
{
    private const int RefreshesPerTable = 50;

    private static readonly TimeSpan RefreshPeriod = TimeSpan.FromMilliseconds(100);

    public void ShowUntilEnd(Task run)
    {
        for (int refresh = 1; !run.Wait(RefreshPeriod); refresh++)
        {
            Refresh();
            if (refresh % RefreshesPerTable != 0)
                continue;
            Console.WriteLine(FlightText.TimeStamp(flight.Now) + GroupText.Head);
            foreach (GroupVehicle vehicle in flight.Vehicles)
                Console.WriteLine(FlightText.TimeStamp(flight.Now) + GroupText.Row(vehicle));
        }

        Refresh();
    }

    private void Refresh()
    {
        foreach (GroupVehicle vehicle in flight.Vehicles)
            vehicle.Refresh();
        foreach (string line in GroupText.TakeLog(flight))
            Console.WriteLine(line);
    }
}
