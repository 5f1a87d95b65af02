using System;
using System.Diagnostics;
using System.Linq;
using System.Text;
using System.Threading;
using Xunit;

namespace Rabit.Diagnostics.Tests;

/// <summary>Clients that are too many, silent, greedy, or send garbage: refused and counted.</summary>
public sealed class HostileClientTests
{
    private const string Every = """{"request":"status","everyMilliseconds":100}""";

    [Fact]
    public void Connect_AFifthClient_IsRefusedUntilOneGoes()
    {
        using var program = new TestProgram();
        TestClient[] clients = Enumerable.Range(0, 4).Select(_ => program.Connect()).ToArray();
        using (var fifth = new TestClient(program.Diagnostics.SocketPath!))
        {
            Assert.Contains("4 clients already", fifth.Read("error").GetProperty("text").GetString());
            Assert.Null(fifth.Read());
        }

        Assert.Equal((4, 4, 1), Clients(program));
        clients[0].Dispose();
        program.Until(c => c.Connected == 3);
        using TestClient next = program.Connect();
        next.Ask("status", """{"request":"status"}""");
        Array.ForEach(clients, c => c.Dispose());
    }

    [Fact]
    public void Request_LongerThanALine_EndsTheClientAndNoOther()
    {
        using var program = new TestProgram();
        using TestClient other = program.Connect();
        using TestClient client = program.Connect();
        client.SendRaw(new byte[4097].AsSpan());

        Assert.Contains("at most 4096 bytes", client.Read("error").GetProperty("text").GetString());
        Assert.Null(client.Read());
        other.Ask("status", """{"request":"status"}""");
        Assert.Equal(1, program.Diagnostics.Counters.RefusedRequests);
    }

    [Fact]
    public void Request_Garbage_EachLineIsRefusedAndTheFloodEndsTheClient()
    {
        using var program = new TestProgram();
        using TestClient client = program.Connect();
        var bytes = new byte[400];
        for (int i = 0; i < bytes.Length; i++)
            bytes[i] = i % 4 == 3 ? (byte)'\n' : (byte)(i * 37);

        client.SendRaw(bytes);

        string last = string.Empty;
        while (client.Read() is { } line)
            last = line.GetProperty("text").GetString()!;
        Assert.Contains("50 requests a second", last);
        program.Until(c => c.Connected == 0);
        Assert.Equal(51, program.Diagnostics.Counters.RefusedRequests);
    }

    [Fact]
    public void Client_ThatAsksForNothing_IsDropped()
    {
        using var program = new TestProgram(limits: l => l with { FirstRequest = TimeSpan.FromMilliseconds(20) });
        using TestClient client = program.Connect();
        client.SendRaw("{\"request"u8);

        Assert.Contains("asked for nothing", client.Read("error").GetProperty("text").GetString());
        Assert.Null(client.Read());
        program.Until(c => c is { Connected: 0, Dropped: 1 });
    }

    [Fact]
    public void Client_ThatReadsNothing_GetsLessAndIsDropped()
    {
        using var program = new TestProgram(limits: l => l with
        {
            MinStatusInterval = TimeSpan.FromMilliseconds(1),
            Send = TimeSpan.FromMilliseconds(300),
        });
        using TestClient client = program.Connect();
        client.Send("""{"request":"status","everyMilliseconds":1}""");

        program.Until(c => c is { Connected: 0, Dropped: 1 });
    }

    [Fact]
    public void Client_ThatReadsLate_GetsTheNumberOfSamplesThatItDidNotGet()
    {
        using var program = new TestProgram(limits: l => l with
        {
            MinStatusInterval = TimeSpan.FromMilliseconds(1),
            Send = TimeSpan.FromSeconds(60),
        });
        using TestClient client = program.Connect();
        client.Send("""{"request":"status","everyMilliseconds":1}""");
        WaitUntilFull(client);

        while (client.Read("status").GetProperty("skippedSamples").GetInt64() == 0)
        {
            // What was sent before is still there.
        }
    }

    // A sample each millisecond: where none comes for long, the way is full. Where the machine has only stood still,
    // samples are skipped by that.
    private static void WaitUntilFull(TestClient client)
    {
        int waiting = 0;
        while (waiting == 0 || client.Waiting != waiting)
        {
            waiting = client.Waiting;
            Thread.Sleep(100);
        }
    }

    [Fact]
    public void Client_ThatHasSentAll_GetsItsAnswersAndIsGone()
    {
        using var program = new TestProgram();
        using TestClient client = program.Connect();
        client.Send("""{"request":"status"}""").Send("""{"request":"graph"}""").EndSending();

        client.Read("status");
        client.Read("graph");
        Assert.Null(client.Read());
        program.Until(c => c.Connected == 0);
        Assert.Equal(0, program.Diagnostics.Counters.Dropped);
    }

    [Fact]
    public void Client_ThatGoesInAStream_IsGone()
    {
        using var program = new TestProgram();
        TestClient client = program.Connect();
        client.Ask("status", Every);
        client.Dispose();

        program.Until(c => c.Connected == 0);
    }

    [Fact]
    public void Request_InPiecesAndSeveralAtOnce_AreServedInTheirOrder()
    {
        using var program = new TestProgram();
        using TestClient client = program.Connect();
        string requests = string.Concat(
            Enumerable.Repeat("{\"request\":\"status\"}\n{\"request\":\"graph\"}\n", 10));
        foreach (byte b in Encoding.UTF8.GetBytes(requests))
            client.SendRaw([b]);

        for (int i = 0; i < 10; i++)
        {
            client.Read("status");
            client.Read("graph");
        }
    }

    [OtherUserFact]
    public void Connect_AsAnotherUser_IsRefused()
    {
        using var program = new TestProgram();
        program.OpenToAll();
        var start = new ProcessStartInfo(
            "setpriv", $"--reuid 65534 --clear-groups socat -u UNIX-CONNECT:{program.Diagnostics.SocketPath} -")
        {
            RedirectStandardOutput = true,
            UseShellExecute = false,
        };

        using Process socat = Process.Start(start)!;
        string answer = socat.StandardOutput.ReadToEnd();
        socat.WaitForExit();

        Assert.Equal("""{"type":"error","text":"This program is of another user."}""", answer.Trim());
        Assert.Equal((0, 0, 1), Clients(program));
    }

    private static (int Connected, long Accepted, long Refused) Clients(TestProgram program)
        => (program.Diagnostics.Counters.Connected, program.Diagnostics.Counters.Accepted,
            program.Diagnostics.Counters.Refused);
}
