using System;
using Rabit.Uav.AutopilotInterface;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

public class AutopilotOptionsTests
{
    [Fact]
    public void Constructor_SeveralFaults_NamesAllOfThem()
    {
        var options = new AutopilotOptions
        {
            SystemId = 0,
            ComponentId = 0,
            HeartbeatTimeout = TimeSpan.FromMilliseconds(999),
            RequestedRates = [new(30, 10), new(30, 5), new(33, 0), new(1, double.NaN), new(24, 1001),
                new(16_000_000, 1)],
        };

        string text = Assert.Throws<ArgumentException>(() => new AutopilotManager(options)).Message;
        string[] parts =
        [
            "SystemId", "ComponentId", "HeartbeatTimeout", "message 30 more than once", "message 33 at 0",
            "message 1 at NaN", "message 24 at 1001", "message 16000000",
        ];
        foreach (string part in parts)
            Assert.Contains(part, text, StringComparison.Ordinal);
    }

    [Fact]
    public void Constructor_NoRates_IsAFaultOnlyWhenNull()
    {
        Assert.NotNull(new AutopilotManager(new AutopilotOptions { RequestedRates = [] }));
        Assert.Throws<ArgumentException>(() => new AutopilotManager(new AutopilotOptions { RequestedRates = null! }));
        Assert.Throws<ArgumentNullException>(() => new AutopilotManager(null!));
    }
}
