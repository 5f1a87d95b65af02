using System;
using System.Threading.Tasks;
using Xunit;

namespace UavService.Tests;

/// <summary>Metrics go to a collector where the configuration says so, and keep the service from nothing.</summary>
public sealed class MetricsTests
{
    private const string Simulated = """{ "Simulation": { "Enabled": true, "Targets": 0 } }""";

    [Fact]
    public async Task Metrics_EndpointConfigured_AreThoseOfAllManagers()
    {
        using var collector = new FakeCollector("rabit.manager.runs");
        using var service = new ServiceProcess(
            Simulated, null, "--Metrics:Endpoint", collector.Endpoint, "--Metrics:Period", "00:00:01");

        string request = await collector.FirstAsync;
        Assert.Equal(0, service.Stop());

        Assert.StartsWith("POST /v1/metrics HTTP/1.1\r\n", request);
        Assert.All(
            ["uav-service", "Rabit.Core", "rabit.run", "rabit.manager.wake.latency", "mission control"],
            name => Assert.Contains(name, request, StringComparison.Ordinal));
    }

    [Fact]
    public void Metrics_NoCollector_IsAWarningAndTheServiceRuns()
    {
        using var service = new ServiceProcess(
            Simulated, null, "--Metrics:Endpoint", "http://127.0.0.1:9/v1/metrics", "--Metrics:Period", "00:00:01");

        service.WaitFor("metrics are not sent ");
        Assert.Equal(0, service.Stop());
    }

    [Theory]
    [InlineData("--Metrics:Endpoint 127.0.0.1:4318", "Metrics:Endpoint is '127.0.0.1:4318'; it must be as http://")]
    [InlineData("--Metrics:Period 00:00:00.1", "Metrics:Period is 00:00:00.1000000; it must be 00:00:01 to 01:00:00")]
    [InlineData("--Metrics:Url x", "Metrics:Url is not known; there are: Endpoint, Period")]
    public void Settings_Wrong_AreNamed(string arguments, string expected)
    {
        using var service = new ServiceProcess(Simulated, null, arguments.Split(' '));

        Assert.Equal(2, service.WaitForEnd());
        Assert.StartsWith("UavService: " + expected, service.Errors);
    }
}
