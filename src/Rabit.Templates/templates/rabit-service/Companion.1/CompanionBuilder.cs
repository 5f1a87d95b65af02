using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using Rabit.Hosting;
using Rabit.Uav.Hosting;

namespace Companion._1;

/// <summary>What the service is made of; the tests make the same.</summary>
public static class CompanionBuilder
{
    public static void AddCompanion(this IHostApplicationBuilder builder)
    {
        // The six managers of Rabit.Uav with the options of the section "Uav", and one of ours, made by the container.
        // The vehicle is only observed: commanding takes Uav:MayCommand and Uav:Mission.
        builder.Services.AddRabitUav(builder.Configuration, uav => uav.AddManager<BatteryAlarm>());
        builder.Services.AddOptions<BatteryAlarmOptions>()
            .BindConfiguration(BatteryAlarmOptions.Section)
            .Validate(
                o => o.LevelFraction is > 0 and < 1,
                $"{BatteryAlarmOptions.Section}:{nameof(BatteryAlarmOptions.LevelFraction)} must be between 0 and 1")
            .ValidateOnStart();

        // Read by ASP.NET Core's MapHealthChecks, or by an IHealthCheckPublisher of your own.
        builder.Services.AddHealthChecks().AddRabit().AddRabitUav();

        // Type=notify: ready when all managers have started, phase and health in "systemctl status".
        builder.Services.AddRabitSystemd();
    }
}
