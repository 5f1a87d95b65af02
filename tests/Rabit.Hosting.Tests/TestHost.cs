using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;
using Rabit.Tests.Shared;

namespace Rabit.Hosting.Tests;

/// <summary>A host of its own for a test: no console, no signals, its log and its exit code kept.</summary>
internal sealed class TestHost : IDisposable
{
    private readonly IHost _host;

    public TestHost(
        Action<IServiceCollection> add, IDictionary<string, string?>? settings = null,
        TimeSpan? shutdownTimeout = null)
    {
        _host = new HostBuilder()
            .ConfigureAppConfiguration(c => c.AddInMemoryCollection(settings ?? new Dictionary<string, string?>()))
            .ConfigureServices(services =>
            {
                services.AddSingleton<IHostLifetime, NoLifetime>();
                services.AddSingleton(new ExitCode(code => ExitCode = code));
                services.Configure<HostOptions>(o => o.ShutdownTimeout = shutdownTimeout ?? TimeSpan.FromSeconds(10));
                services.AddLogging(l => l.SetMinimumLevel(LogLevel.Trace).AddProvider(Log));
                add(services);
            })
            .Build();
    }

    public RecordedLog Log { get; } = new();

    public int ExitCode { get; private set; }

    public IServiceProvider Services => _host.Services;

    public HostedReactors Reactors => Services.GetRequiredService<HostedReactors>();

    public async Task StartAsync() => await _host.StartAsync();

    public async Task StopAsync(CancellationToken token = default) => await _host.StopAsync(token);

    /// <summary>Until the one reactor has ended.</summary>
    public async Task WaitForReactorAsync()
        => await Task.WhenAny(Reactors.Find("rabit")!.Ended, Task.Delay(TestTimeout.Limit));

    /// <summary>Until something stops the host from inside; then stops it.</summary>
    public async Task WaitForEndAsync()
    {
        Task stopped = _host.WaitForShutdownAsync();
        Task first = await Task.WhenAny(stopped, Task.Delay(TestTimeout.Limit));
        Xunit.Assert.True(first == stopped, "The host does not stop.\n" + Log);
        await stopped;
    }

    public void Dispose() => _host.Dispose();

    private sealed class NoLifetime : IHostLifetime
    {
        public Task WaitForStartAsync(CancellationToken cancellationToken) => Task.CompletedTask;

        public Task StopAsync(CancellationToken cancellationToken) => Task.CompletedTask;
    }
}
