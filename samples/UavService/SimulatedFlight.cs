using System;
using System.Collections.Generic;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Options;
using Rabit.Links;
using Rabit.Uav;
using Rabit.Uav.Hosting;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Simulation;

namespace UavService;

/// <summary>A simulated vehicle in the place of one behind a link, in real time: to try the service.</summary>
internal static class SimulatedFlight
{
    /// <summary>Adds the vehicle and its camera, where the configuration asks for them.</summary>
    /// <exception cref="SettingException">Its settings are wrong.</exception>
    public static void AddSimulation(this RabitUavBuilder uav, IConfiguration configuration)
    {
        SimulationSettings settings = SimulationSettings.Read(configuration);
        if (!settings.Enabled)
            return;
        uav.Services.AddSingleton<IValidateOptions<UavOptions>>(new ValidateOptions<UavOptions>(
            Options.DefaultName,
            options => options.Links.Count == 0,
            "Simulation:Enabled is true, but there are links in Uav:Links: a vehicle is one or the other"));
        uav.Configure((_, options) => Simulate(settings, options));
    }

    private static void Simulate(SimulationSettings settings, UavOptions options)
    {
        var worldOptions = new SimulationOptions { Seed = settings.Seed, TargetCount = settings.Targets };
        if (options.Mission is not null)
            worldOptions.TakePlacesFrom(options.Mission);
        var world = new SimulatedWorld(worldOptions);
        var telemetry = new MemoryLinkPair("telemetry");
        options.OpenLinks = [telemetry.A];
        options.OtherManagers = [world.CreateVehicle(telemetry.B)];

        // The mission is the one that a real vehicle would fly; only here it needs no word of the operator.
        options.MayCommand = options.Mission is not null;
        options.Camera = world.CreateCamera();
        (options.Imaging.Camera, options.Imaging.Mount) = (world.CameraModel, world.CameraMount);
    }
}
