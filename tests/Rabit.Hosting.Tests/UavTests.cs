using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Diagnostics.HealthChecks;
using Microsoft.Extensions.Options;
using Rabit.Core;
using Rabit.Tests.Shared;
using Rabit.Uav;
using Rabit.Uav.Hosting;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Vision;
using Xunit;

namespace Rabit.Hosting.Tests;

/// <summary>A companion computer of a host is what the configuration says, or does not start.</summary>
public sealed class UavTests
{
    private const string Link = "udpout:127.0.0.1:9";
    private const string Search = "the mission of the sample";

    [Fact]
    public void Settings_OfAllKinds_AreThoseOfTheOptions()
    {
        UavOptions options = Read(
            out IReadOnlyList<string> faults,
            ("Uav:Links:0", Link), ("Uav:Links:1", "tcp:127.0.0.1:5760,optional"), ("Uav:SystemId", "7"),
            ("Uav:MayCommand", "true"), ("Uav:Mission", Mission), ("Uav:UploadsFence", "true"),
            ("Uav:Without", "ImageProcessing, sensorFusion"), ("Uav:Seed", "12"),
            ("Uav:Health:BatteryLowFraction", "0.3"), ("Uav:Health:AutopilotTimeout", "00:00:03"),
            ("Uav:Autopilot:Setup:SetsFailsafes", "true"), ("Uav:Autopilot:Setup:OriginalsFile", "originals.json"),
            ("Uav:Imaging:MinDepression", "12.5"), ("Uav:Imaging:Errors:PixelNoise", "0.7"),
            ("Uav:Imaging:LandingMarker:Family", "ArUco4x4"), ("Uav:Imaging:LandingMarker:SideMetres", "0.4"),
            ("Uav:MissionControl:OnStop", "Return"), ("Uav:MissionControl:Energy:Cells", "6"),
            ("Uav:GroundCommands:SystemIds:0", "255"), ("Uav:GroundCommands:SystemIds:1", "254"),
            ("Uav:Preflight:Overrides:0", "fence"), ("Uav:Communications:Recording:Folder", "/flights"));

        Assert.Empty(faults);
        Assert.Equal(2, options.Links.Count);
        Assert.Equal((byte)7, options.SystemId);
        Assert.NotNull(options.Mission);
        Assert.NotNull(options.Autopilot.Setup.Fence);
        Assert.Equal(UavManagers.ImageProcessing | UavManagers.SensorFusion, options.Without);
        Assert.Equal(12, options.Seed);
        Assert.Equal(0.3, options.Health.BatteryLowFraction);
        Assert.Equal(TimeSpan.FromSeconds(3), options.Health.AutopilotTimeout);
        Assert.True(options.Autopilot.Setup.SetsFailsafes);
        Assert.Equal(12.5, options.Imaging.MinDepression.Degrees, 9);
        Assert.Equal(0.7, options.Imaging.Errors.PixelNoise);
        Assert.Equal(
            (MarkerFamily.ArUco4x4, 0, 0.4),
            (options.Imaging.LandingMarker!.Family, options.Imaging.LandingMarker.Id,
                options.Imaging.LandingMarker.SideMetres));
        Assert.Equal(OnStop.Return, options.MissionControl.OnStop);
        Assert.Equal(6, options.MissionControl.Energy.Cells);
        Assert.Equal(new byte[] { 255, 254 }, options.GroundCommands!.SystemIds);
        Assert.Equal(["fence"], options.Preflight.Overrides);
        Assert.Equal("/flights", options.Communications.Recording!.Folder);
    }

    [Theory]
    [InlineData("Uav:Helth", "1", "Uav:Helth is not known; there are: Autopilot, Camera, Communications, ")]
    [InlineData("Uav:Health:BatteryLow", "1", "Uav:Health:BatteryLow is not known; there are: AutopilotTimeout, ")]
    [InlineData("Uav:Autopilot:MayCommand", "true", "Uav:Autopilot:MayCommand is not known; ")]
    [InlineData("Uav:Autopilot:Setup:Fence", "x", "Uav:Autopilot:Setup:Fence is not known; ")]
    [InlineData("Uav:Health:AutopilotTimeout", "5", "Uav:Health:AutopilotTimeout is '5'; it must be a time, as ")]
    [InlineData("Uav:Health:BatteryLowFraction", "NaN", "Uav:Health:BatteryLowFraction is 'NaN'; it must be a number")]
    [InlineData("Uav:SystemId", "256", "Uav:SystemId is '256'; it must be a whole number from 0 to 255")]
    [InlineData("Uav:SystemId", "", "Uav:SystemId is empty")]
    [InlineData("Uav:MayCommand", "yes", "Uav:MayCommand is 'yes'; it must be true or false")]
    [InlineData("Uav:Without", "32", "Uav:Without is '32'; it must be one of None, ")]
    [InlineData("Uav:MissionControl:OnStop", "Hold,Land", "Uav:MissionControl:OnStop is 'Hold,Land'; it must be one ")]
    [InlineData("Uav:Links", Link, "Uav:Links is '" + Link + "'; it must be a list, as Uav:Links:0")]
    [InlineData("Uav:Links:0", "udp:1", "Uav:Links:0 is 'udp:1'; ")]
    [InlineData("Uav:Links:0:Url", Link, "Uav:Links:0 has settings in it; it must be one value")]
    [InlineData("Uav:Health", "good", "Uav:Health is 'good'; it must have settings in it")]
    [InlineData("Uav:Mission", "/none/x.json", "Uav:Mission is '/none/x.json'; ")]
    [InlineData("Uav:Terrain", "/none/x.asc", "Uav:Terrain is '/none/x.asc'; ")]
    [InlineData("Uav:MissionControl:Resume", "/none/p.json", "Uav:MissionControl:Resume is '/none/p.json'; ")]
    [InlineData("Uav:Camera", "/none", "Uav:Camera: ")]
    [InlineData("Uav:Signing:KeyFile", "/none", "Uav:Signing:KeyFile: ")]
    [InlineData("Uav:Signing:KeyFil", "/none", "Uav:Signing:KeyFil is not known; there are: KeyFile, TrustedLinks")]
    [InlineData("Uav:UploadsFence", "true", "Uav:UploadsFence is true, but there is no Mission ")]
    public void Setting_Wrong_IsNamedWithItsKey(string key, string value, string expected)
    {
        Read(out IReadOnlyList<string> faults, (key, value));

        Assert.StartsWith(expected, Assert.Single(faults), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Settings_Wrong_EndTheStartWithAllOfThem()
    {
        using var host = HostOf(
            null, ("Uav:Links:0", Link), ("Uav:Helth", "1"), ("Uav:MayCommand", "yes"),
            ("Uav:Health:BatteryLowFraction", "3"), ("Uav:ComponentId", "0"));

        RabitHostingException e = await Assert.ThrowsAsync<RabitHostingException>(host.StartAsync);

        Assert.Contains(e.Faults, f => f.StartsWith("Uav:Helth is not known; ", StringComparison.Ordinal));
        Assert.Contains("Uav:MayCommand is 'yes'; it must be true or false", e.Faults);
        Assert.Contains(e.Faults, f => f.StartsWith("Uav:Health:BatteryLowFraction is 3", StringComparison.Ordinal));
        Assert.Contains("Uav:ComponentId is 0; it must be 1 to 255", e.Faults);
        Assert.Equal(4, e.Faults.Count);
    }

    [Theory]
    [InlineData("Uav:Links:0 is 'udp:1'; ", "Uav:Links:0", "udp:1")]
    [InlineData("Uav:Links is 'udp:1'; ", "Uav:Links", "udp:1")]
    [InlineData("Uav:Lnks is not known; ", "Uav:Lnks:0", Link)]
    [InlineData("Uav:MayCommand is 'yes'; ", "Uav:MayCommand", "yes", "Uav:Mission", Search, "Uav:Links:0", Link)]
    public async Task Setting_CannotBeRead_WhatFollowsFromItIsNotReported(string expected, params string[] settings)
    {
        using var host = HostOf(
            null,
            Enumerable.Range(0, settings.Length / 2)
                .Select(i => (settings[2 * i], ValueOf(settings[(2 * i) + 1]))).ToArray());

        RabitHostingException e = await Assert.ThrowsAsync<RabitHostingException>(host.StartAsync);

        Assert.StartsWith(expected, Assert.Single(e.Faults), StringComparison.Ordinal);
    }

    [Fact]
    public void Camera_FileWithASource_IsTheProgramThatItNames()
    {
        string file = Path.GetTempFileName();
        try
        {
            File.WriteAllText(file, """
                { "source": { "program": "rpicam-vid", "framesPerSecond": 4 },
                  "camera": { "width": 640, "height": 480, "horizontalFieldOfViewDegrees": 62,
                    "mount": { "bodyFromCamera": [[0, -1, 0], [1, 0, 0], [0, 0, 1]],
                      "leverArmBodyMetres": [0, 0, 0] } } }
                """);

            UavOptions options = Read(
                out IReadOnlyList<string> faults, ("Uav:Links:0", Link), ("Uav:Camera", file));

            Assert.Empty(faults);
            Assert.Equal("rpicam-vid", Assert.IsType<ProcessCamera>(options.Camera).Name);
            Assert.Equal(640, options.Imaging.Camera!.Width);
        }
        finally
        {
            File.Delete(file);
        }
    }

    [Fact]
    public void KeyFile_Missing_IsNamedInOneSentence()
    {
        Read(out IReadOnlyList<string> faults, ("Uav:Links:0", Link), ("Uav:Signing:KeyFile", "/none"));

        string fault = Assert.Single(faults);
        Assert.StartsWith("Uav:Signing:KeyFile: ", fault, StringComparison.Ordinal);
        Assert.Contains("/none", fault, StringComparison.Ordinal);   // quoted as the runtime does
        Assert.DoesNotContain('\n', fault);
    }

    [Fact]
    public async Task Start_LinksOnly_RunsTheSixAndStopsInOrder()
    {
        using var host = HostOf(null, ("Uav:Links:0", Link));
        await host.StartAsync();

        Assert.Equal(6, host.Reactors["rabit"].Count());
        Assert.Equal("vehicle", Assert.Single(await CheckAsync(host)).Key);
        await host.StopAsync();
        Assert.Equal(0, host.ExitCode);
    }

    [Fact]
    public async Task Health_NoAutopilot_IsNotHealthyAndSaysWhyAsData()
    {
        using var host = HostOf(null, ("Uav:Links:0", Link));
        Assert.Equal(HealthStatus.Unhealthy, (await CheckAsync(host))["vehicle"].Status);
        await host.StartAsync();
        HealthReportEntry entry = (await CheckAsync(host))["vehicle"];
        var timeout = new TestTimeout();
        while ((string)entry.Data["level"] == "Unknown" && await timeout.TryWaitAsync())
        {
            entry = (await CheckAsync(host))["vehicle"];
        }

        await host.StopAsync();

        Assert.NotEqual(HealthStatus.Healthy, entry.Status);
        Assert.Contains("NoAutopilot", (string[])entry.Data["reasons"]);
        Assert.Equal(HealthStatus.Unhealthy, (await CheckAsync(host))["vehicle"].Status);
    }

    [Fact]
    public async Task Manager_Replaced_TakesThePartOfOurs()
    {
        using var host = HostOf(
            uav => uav.Replace<SmartCamera>(UavManagers.ImageProcessing), ("Uav:Links:0", Link));
        await host.StartAsync();
        string[] managers = host.Reactors["rabit"].Select(m => m.Name).ToArray();
        await host.StopAsync();

        Assert.Contains("smart camera", managers);
        Assert.DoesNotContain("image processing", managers);
        Assert.Equal(0, host.ExitCode);
    }

    [Fact]
    public async Task Manager_LeftOut_IsNamedWithWhatIsMissing()
    {
        using var host = HostOf(null, ("Uav:Links:0", Link), ("Uav:Without", "ImageProcessing"));

        RabitWiringException e = await Assert.ThrowsAsync<RabitWiringException>(host.StartAsync);

        Assert.Contains(e.Faults, f => f.Contains("UavOptions.Without has ImageProcessing"));
    }

    [Fact]
    public async Task Managers_OfTheUser_CannotBeMadeAndAreNamed()
    {
        using var host = HostOf(
            uav => uav.AddManager<Source>().AddManager<Sink>(), ("Uav:Links:0", Link));

        RabitHostingException e = await Assert.ThrowsAsync<RabitHostingException>(host.StartAsync);

        Assert.Collection(
            e.Faults,
            f => Assert.StartsWith("Source cannot be made: ", f),
            f => Assert.StartsWith("Sink cannot be made: ", f));
    }

    [Fact]
    public void Configure_InCode_ComesAfterTheConfiguration()
    {
        using var host = HostOf(
            uav => uav.Configure((_, o) => o.SystemId = 9).LeaveOut(UavManagers.ImageProcessing),
            ("Uav:Links:0", Link), ("Uav:SystemId", "7"), ("Uav:Without", "SensorFusion"));

        UavOptions options = host.Services.GetRequiredService<IOptions<UavOptions>>().Value;

        Assert.Equal((byte)9, options.SystemId);
        Assert.Equal(UavManagers.ImageProcessing | UavManagers.SensorFusion, options.Without);
    }

    [Fact]
    public async Task Setup_OfCodeOutsideManagers_SeesTheReactorWithItsManagersBeforeItStarts()
    {
        RabitReactor? seen = null;
        int managers = 0;
        bool wasWired = true;
        using var host = HostOf(
            uav => uav.Setup((_, reactor) =>
            {
                (seen, managers, wasWired) = (reactor, reactor.Count(), reactor.IsWired);
            }),
            ("Uav:Links:0", Link));
        await host.StartAsync();

        Assert.Same(host.Reactors["rabit"], seen);
        Assert.Equal((6, false), (managers, wasWired));
        await host.StopAsync();
    }

    [Fact]
    public void AddRabitUav_Twice_IsRefused()
    {
        IConfiguration configuration = Configuration();
        Assert.Throws<InvalidOperationException>(
            () => new ServiceCollection().AddRabitUav(configuration).AddRabitUav(configuration));
    }

    private static string Mission => Path.Combine(Repository.Root, "samples", "UavConsole", "missions", "search.json");

    private static string ValueOf(string value) => value == Search ? Mission : value;

    private static IConfiguration Configuration(params (string Key, string Value)[] settings)
        => new ConfigurationBuilder()
            .AddInMemoryCollection(settings.Select(s => new KeyValuePair<string, string?>(s.Key, s.Value))).Build();

    private static UavOptions Read(out IReadOnlyList<string> faults, params (string Key, string Value)[] settings)
    {
        var options = new UavOptions();
        faults = UavConfiguration.Apply(Configuration(settings).GetSection("Uav"), options);
        return options;
    }

    private static TestHost HostOf(Action<RabitUavBuilder>? configure, params (string Key, string Value)[] settings)
        => new(s =>
        {
            s.AddRabitUav(Configuration(settings), configure);
            s.AddHealthChecks().AddRabitUav();
        });

    private static async Task<IReadOnlyDictionary<string, HealthReportEntry>> CheckAsync(TestHost host)
        => (await host.Services.GetRequiredService<HealthCheckService>().CheckHealthAsync()).Entries;

    private sealed class SmartCamera : RabitManager
    {
        public SmartCamera()
            : base("smart camera")
        {
            Receive<PoseSample>(MessageNames.Poses, 1000, QueueFullMode.DropOldest);
            Send<CameraObservation>(MessageNames.CameraObservations);
            Send<CameraObservation>(MessageNames.SearchedGround);
            Publish<ImagingStatus>(MessageNames.Imaging);
        }

        protected override void ExecuteUnitOfWork()
        {
        }
    }
}
