using System;
using System.IO;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;

namespace UavService.Tests;

/// <summary>The sample as a service: what it notifies of, how it ends, and what it says to bad input.</summary>
public sealed class ServiceTests
{
    private const string Simulated = """{ "Simulation": { "Enabled": true, "Targets": 0 } }""";
    private const string OnLink = """{ "Uav": { "Links": [ "serial:/dev/ttyNone:57600" ] } }""";

    private static readonly string Sample = Path.Combine(Repository.Root, "samples", "UavService");

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Service_OfSystemd_IsReadyShowsPhaseAndHealthAndStops(bool isAbstract)
    {
        using var systemd = new FakeSystemd(isAbstract);
        using var service = new ServiceProcess(Simulated, systemd.Address);

        Assert.Equal("READY=1", systemd.WaitFor("="));
        service.WaitFor("starts communications, autopilot, ");
        Assert.StartsWith("STATUS=phase NoMission, health ", systemd.WaitFor("STATUS="));
        systemd.WaitFor("STATUS=phase NoMission, health Good; 7 managers run");
        Assert.Equal(0, service.Stop());

        Assert.StartsWith("STOPPING=1\nEXTEND_TIMEOUT_USEC=30000000\nSTATUS=", systemd.WaitFor("STOPPING=1"));
        Assert.DoesNotContain(systemd.All, n => n.Contains("WATCHDOG", StringComparison.Ordinal));
        Assert.Empty(service.Errors);
    }

    [Fact]
    public void Service_DeviceNotThere_IsReadyAndSaysSo()
    {
        using var systemd = new FakeSystemd(isAbstract: true);
        using var service = new ServiceProcess(OnLink, systemd.Address);

        Assert.Equal("READY=1", systemd.WaitFor("="));
        Assert.StartsWith("STATUS=phase NoMission, health Critical ", systemd.WaitFor("LinkDown"));
        service.WaitFor("vehicle is Unhealthy: link serial:/dev/ttyNone:57600 is not open, and is tried again");
        Assert.Equal(0, service.Stop());
    }

    [Fact]
    public void Service_NotificationsGoNowhere_RunsWithAWarning()
    {
        using var service = new ServiceProcess(Simulated, "/nowhere/notify");

        service.WaitFor("systemd cannot be notified at /nowhere/notify");
        service.WaitFor("Application started");
        Assert.Equal(0, service.Stop());
    }

    [Theory]
    [InlineData("""{ "Uav": { "Links": [ } }""", "", "appsettings.json'. Could not parse the JSON file.")]
    [InlineData("""[ 1 ]""", "", "appsettings.json'. Top-level JSON element must be an object.")]
    [InlineData(null, "", "there are no settings: no ")]
    [InlineData("""{ "Uva": { } }""", "", "Uva of appsettings.json is not known; there are: Simulation, Uav, ")]
    [InlineData(OnLink, "--Uav:Helth 1", "Uav:Helth is not known; there are: Autopilot, ")]
    [InlineData(OnLink, "--Uva:SystemId 7", "Uva of the command line is not known; ")]
    [InlineData(OnLink, "mission.json", "mission.json of the command line is not known; ")]
    [InlineData(OnLink, "--Uav:Mission none.json", "Uav:Mission is 'none.json'; Could not find file ")]
    [InlineData(OnLink, "--Simulation:Enabled true", "Simulation:Enabled is true, but there are links in Uav:Links")]
    [InlineData(Simulated, "--Simulation:Seed x", "Failed to convert configuration value 'x' at 'Simulation:Seed'")]
    [InlineData(Simulated, "--Simulation:Targets 51", "Simulation:Targets is 51; it must be 0 to 50")]
    [InlineData(Simulated, "--Simulation:Sed 1", "Simulation:Sed is not known; there are: Enabled, Seed, Targets")]
    public void Settings_Wrong_AreOneLineAndExitCode2(string? settings, string arguments, string expected)
    {
        using var systemd = new FakeSystemd(isAbstract: true);
        using var service = new ServiceProcess(
            settings, systemd.Address, arguments.Split(' ', StringSplitOptions.RemoveEmptyEntries));

        Assert.Equal(2, service.WaitForEnd());
        string line = Assert.Single(service.Errors.Split('\n', StringSplitOptions.RemoveEmptyEntries));
        Assert.StartsWith("UavService: ", line);
        Assert.Contains(expected, line, StringComparison.Ordinal);
        Assert.Empty(service.Output);
    }

    [Fact]
    public void Check_SettingsAsShipped_AreGoodAndNothingRuns()
    {
        using var service = new ServiceProcess(
            File.ReadAllText(Path.Combine(Sample, "appsettings.json")), null, "--check", "--Uav:Mission",
            Path.Combine(Sample, "missions", "search.json"));

        Assert.Equal(0, service.WaitForEnd());
        Assert.Equal(
            "The settings are good: a simulated vehicle flies 'search of a meadow'.\n", service.Output);
    }

    [Fact]
    public void Unit_HasNoWatchdogAndWaitsForReadiness()
    {
        string[] lines = File.ReadAllLines(Path.Combine(Sample, "uav-service.service"));

        Assert.Contains("Type=notify", lines);
        Assert.DoesNotContain(lines, l => l.StartsWith("WatchdogSec", StringComparison.Ordinal));
        Assert.Contains(lines, l => l.StartsWith("# There is no WatchdogSec", StringComparison.Ordinal));
        string timeout = lines.Single(l => l.StartsWith("TimeoutStopSec=", StringComparison.Ordinal)).Split('=')[1];
        Assert.InRange(int.Parse(timeout, null), 31, 120);   // above the host's 30 s
    }
}
