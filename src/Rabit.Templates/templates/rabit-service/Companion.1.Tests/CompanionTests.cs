using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Options;
using Rabit.Hosting;
using Rabit.Uav;
using Xunit;

namespace Companion._1.Tests;

/// <summary>The service as it is composed: the settings as shipped, and what is said of wrong ones.</summary>
public sealed class CompanionTests
{
    [Fact]
    public void Settings_AsShipped_AreGood()
    {
        using IHost host = Build();

        UavOptions options = host.Services.GetRequiredService<IOptions<UavOptions>>().Value;
        Assert.Equal("udpin:0.0.0.0:14550", Assert.Single(options.Links).ToString());
        Assert.False(options.MayCommand);
    }

    [Fact]
    public async Task Host_StartedAndStopped_RunsAllManagersAndEndsInOrder()
    {
        using IHost host = Build(("Uav:Links:0", "udpout:127.0.0.1:9"));   // a port that no program listens on
        await host.StartAsync();
        string[] managers = host.Services.GetRequiredService<HostedReactors>()["rabit"].Select(m => m.Name).ToArray();
        await host.StopAsync();

        Assert.Equal(7, managers.Length);
        Assert.Contains("battery alarm", managers);
        Assert.Equal(0, Environment.ExitCode);
    }

    [Theory]
    [InlineData("Uav:Helth:BatteryLowFraction", "0.3", "Uav:Helth is not known")]
    [InlineData("BatteryAlarm:LevelFraction", "30", "BatteryAlarm:LevelFraction must be between 0 and 1")]
    public async Task Setting_Wrong_EndsTheStartByName(string key, string value, string expected)
    {
        using IHost host = Build((key, value));

        Exception e = await Assert.ThrowsAnyAsync<Exception>(() => host.StartAsync());
        Assert.Contains(expected, e.Message, StringComparison.Ordinal);
    }

    // Without the console's log and without signals; appsettings.json is beside the tests.
    private static IHost Build(params (string Key, string Value)[] settings)
    {
        HostApplicationBuilder builder = Host.CreateEmptyApplicationBuilder(
            new HostApplicationBuilderSettings { ContentRootPath = AppContext.BaseDirectory });
        builder.Configuration.AddJsonFile("appsettings.json");
        builder.Configuration.AddInMemoryCollection(
            settings.Select(s => KeyValuePair.Create(s.Key, (string?)s.Value)));
        builder.AddCompanion();
        return builder.Build();
    }
}
