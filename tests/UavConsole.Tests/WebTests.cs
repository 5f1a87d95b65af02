using System;
using System.IO;
using System.Net;
using System.Net.Sockets;
using System.Text;
using System.Threading.Tasks;
using Xunit;

namespace UavConsole.Tests;

/// <summary>The live page of a run. Under Mono there is none, which is said.</summary>
public sealed class WebTests
{
    private static readonly bool IsMono = Type.GetType("Mono.Runtime") is not null;

    [Fact]
    public async Task Web_FreePort_ServesThePageWhileItFlies()
    {
        if (IsMono)
            return;   // the next test has what is said there
        using ConsoleProcess process = ConsoleProcess.Start("--realtime", "--headless", "--web", "0");
        string address = process.WaitFor("live page: http://127.0.0.1:").Substring("live page: ".Length);
        process.WaitForStart();
        Assert.Equal("HTTP/1.1 200 OK", await GetAsync(new Uri(address)));
        process.Signal(ConsoleProcess.Interrupt);
        Assert.InRange(process.WaitForEnd(), 0, 1);
    }

    [Theory]
    [InlineData("--web-token file", "--web-token goes with --web.")]
    [InlineData("--web-tiles folder --web-host a", "--web-tiles goes with --web. --web-host goes with --web.")]
    [InlineData("--web 300.0.0.1:80", "--web 300.0.0.1:80: it must be ADDRESS:PORT or PORT")]
    [InlineData("--web 0.0.0.0:8080", "--web 0.0.0.0:8080 can be reached from other computers: it needs --web-token FILE.")]
    [InlineData("--web --web-token /nowhere/token", "Token /nowhere/token: ")]
    [InlineData("--web 0 --web-tiles /nowhere/tiles", "TileFolder: there is no folder /nowhere/tiles")]
    public void Web_BadInput_IsOneLineAndExitCode2(string arguments, string expected)
    {
        string line = Assert.Single(CommandLineRun.Refuse(arguments.Split(' ')));
        Assert.Contains(IsMono && !expected.Contains("goes with") ? "needs .NET 10" : expected, line);
    }

    [Fact]
    public void Web_PortThatIsTaken_IsOneLineAndExitCode2()
    {
        var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        string address = listener.LocalEndpoint.ToString()!;
        string line = Assert.Single(CommandLineRun.Refuse("--web", address));
        listener.Stop();
        Assert.Contains(IsMono ? "needs .NET 10" : "The live page cannot listen at " + address, line);
    }
    // The first line of the answer.
    private static async Task<string?> GetAsync(Uri address)
    {
        using var client = new TcpClient();
        await client.ConnectAsync(IPAddress.Loopback, address.Port);
        using var writer = new StreamWriter(client.GetStream(), Encoding.ASCII) { AutoFlush = true };
        using var reader = new StreamReader(client.GetStream());
        await writer.WriteAsync("GET / HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
        return await reader.ReadLineAsync();
    }
}
