using System;
using System.Linq;
using System.Text.Json;
using Rabit.Core;
using Xunit;

namespace Rabit.Diagnostics.Tests;

/// <summary>What clients are answered.</summary>
public sealed class StatusTests
{
    private const string Every = """{"request":"status","everyMilliseconds":100}""";

    [Fact]
    public void Status_BeforeTheStart_HasTheReactorAndNothingInIt()
    {
        using var program = new TestProgram(starts: false);
        using TestClient client = program.Connect();
        JsonElement before = Reactor(client.Ask("status", """{"request":"status"}"""));
        Assert.False(before.GetProperty("isStarted").GetBoolean());
        Assert.Equal(0, before.GetProperty("managers").GetArrayLength());

        program.Start();
        JsonElement after = Reactor(client.Ask("status", """{"request":"status"}"""));
        Assert.Equal(2, after.GetProperty("managers").GetArrayLength());
    }

    [Fact]
    public void Status_OfARun_HasManagersQueuesAndMessages()
    {
        using var program = new TestProgram();
        program.Reactor.RunFor(TimeSpan.FromSeconds(1));
        using TestClient client = program.Connect();

        JsonElement reactor = Reactor(client.Ask("status", """{"request":"status","reactor":"main"}"""));

        Assert.Equal(1, reactor.GetProperty("timeSeconds").GetDouble());
        JsonElement[] managers = reactor.GetProperty("managers").EnumerateArray().ToArray();
        Assert.Equal(["source", "sink"], managers.Select(m => m.GetProperty("name").GetString()));
        Assert.Equal("running", managers[0].GetProperty("state").GetString());
        Assert.Equal(11, managers[0].GetProperty("runs").GetInt64());
        Assert.Equal(10, managers[0].GetProperty("wakeUps").GetProperty("timer").GetInt64());
        Assert.Equal(0, managers[0].GetProperty("missedDeadlines").GetInt64());
        Assert.True(managers[1].GetProperty("wakeUps").GetProperty("post").GetInt64() > 0);
        JsonElement queue = Assert.Single(reactor.GetProperty("queues").EnumerateArray());
        Assert.Equal(
            ("numbers", "Int32", 3, 3, 3, 11, 8),
            (queue.GetProperty("name").GetString(), queue.GetProperty("valueType").GetString(),
                queue.GetProperty("level").GetInt32(), queue.GetProperty("highWater").GetInt32(),
                queue.GetProperty("capacity").GetInt32(), queue.GetProperty("pushed").GetInt64(),
                queue.GetProperty("dropped").GetInt64()));
        JsonElement message = Assert.Single(reactor.GetProperty("messages").EnumerateArray());
        Assert.Equal(
            ("pose", "Pose", 11, 0),
            (message.GetProperty("name").GetString(), message.GetProperty("valueType").GetString(),
                message.GetProperty("posts").GetInt64(), message.GetProperty("ageSeconds").GetDouble()));
    }

    [Fact]
    public void StatusStream_WhileTheRunContinues_HasRatesByItsClock()
    {
        using var program = new TestProgram();
        using TestClient client = program.Connect();
        JsonElement first = client.Ask("status", Every);
        Assert.Equal(1, first.GetProperty("sequence").GetInt64());
        Assert.False(Reactor(first).GetProperty("managers")[0].TryGetProperty("runsPerSecond", out _));

        program.Reactor.RunFor(TimeSpan.FromSeconds(10));
        JsonElement reactor;
        do
        {
            reactor = Reactor(client.Read("status"));
        }
        while (reactor.GetProperty("timeSeconds").GetDouble() < 10);

        // The ten seconds may have been seen in two parts.
        Assert.Equal(10, reactor.GetProperty("managers")[0].GetProperty("runsPerSecond").GetDouble(), 0.5);
        Assert.Equal(10, reactor.GetProperty("queues")[0].GetProperty("pushesPerSecond").GetDouble(), 0.5);
        Assert.Equal(10, reactor.GetProperty("messages")[0].GetProperty("postsPerSecond").GetDouble(), 0.5);
        Assert.InRange(reactor.GetProperty("managers")[0].GetProperty("load").GetDouble(), 0, 1);
        Assert.True(reactor.GetProperty("speed").GetDouble() > 1);
    }

    [Fact]
    public void Add_WhileAClientIsConnected_ShowsTheReactorToIt()
    {
        using var program = new TestProgram();
        using var other = new RabitReactor(new ReactorOptions { Name = "other", StopsOnSignals = false });
        using TestClient client = program.Connect();
        Assert.Equal(1, client.Ask("status", Every).GetProperty("reactors").GetArrayLength());

        program.Diagnostics.Add(other);
        program.Diagnostics.Add(program.Reactor);

        JsonElement reactors;
        do
        {
            reactors = client.Read("status").GetProperty("reactors");
        }
        while (reactors.GetArrayLength() == 1);
        Assert.Equal(["main", "other"], reactors.EnumerateArray().Select(r => r.GetProperty("name").GetString()));
    }

    [Fact]
    public void Status_AfterTheRun_SaysThatTheManagersHaveStopped()
    {
        using var program = new TestProgram();
        program.Reactor.Stop();
        program.Reactor.Finish();
        using TestClient client = program.Connect();

        JsonElement reactor = Reactor(client.Ask("status", """{"request":"status"}"""));

        Assert.All(
            reactor.GetProperty("managers").EnumerateArray(),
            m => Assert.Equal("stopped", m.GetProperty("state").GetString()));
    }

    [Fact]
    public void Graph_InEachFormat_IsThatOfTheWorkspace()
    {
        using var program = new TestProgram();
        using TestClient client = program.Connect();
        Assert.StartsWith("managers", Graph("""{"request":"graph"}"""), StringComparison.Ordinal);
        Assert.StartsWith("flowchart", Graph("""{"request":"graph","format":"Mermaid"}"""), StringComparison.Ordinal);
        Assert.StartsWith("digraph", Graph("""{"request":"graph","format":"dot"}"""), StringComparison.Ordinal);

        string Graph(string request)
            => Reactor(client.Ask("graph", request)).GetProperty("text").GetString()!;
    }

    [Fact]
    public void Echo_OfAMessage_HasItsValueAndStamp()
    {
        using var program = new TestProgram();
        program.Reactor.RunFor(TimeSpan.FromSeconds(1));
        using TestClient client = program.Connect();

        JsonElement line = client.Ask("value", """{"request":"echo","message":"pose"}""");

        Assert.Equal(11, line.GetProperty("post").GetInt64());
        Assert.Equal(1, line.GetProperty("timeSeconds").GetDouble());
        Assert.Equal("""{"northMetres":11,"twiceMetres":22}""", line.GetProperty("value").GetRawText());
    }

    [Fact]
    public void EchoStream_WhileTheRunContinues_HasEachValueThatItSawAndCountsTheOthers()
    {
        using var program = new TestProgram();
        using TestClient client = program.Connect();
        JsonElement first = client.Ask("value", """{"request":"echo","message":"pose","everyMilliseconds":10}""");
        Assert.Equal(1, first.GetProperty("post").GetInt64());

        program.Reactor.RunFor(TimeSpan.FromSeconds(1));
        long seen = 1, missed = 0, post = 1;
        while (post < 11)
        {
            JsonElement line = client.Read("value");
            post = line.GetProperty("post").GetInt64();
            seen++;
            missed += line.GetProperty("missedPosts").GetInt64();
        }

        Assert.Equal(11, seen + missed);
    }

    [Fact]
    public void Echo_OfAStatus_IsThatOfTheManager()
    {
        using var program = new TestProgram();
        using TestClient client = program.Connect();

        JsonElement line = client.Ask("value", """{"request":"echo","message":"source/status","reactor":"main"}""");

        Assert.Equal("Running", line.GetProperty("value").GetProperty("state").GetString());
    }

    [Theory]
    [InlineData("""{"request":"echo","message":"poes"}""", "no message 'poes'; there are: pose.")]
    [InlineData("""{"request":"echo","message":"pose","reactor":"x"}""", "no reactor 'x'; there are: main.")]
    [InlineData("""{"request":"echo"}""", "has a member \"message\"")]
    [InlineData("""{"request":"graph","format":"3"}""", "no format '3'")]
    [InlineData("""{"request":"status","everyMilliseconds":5}""", "it must be 100 to 60000")]
    [InlineData("""{"request":"status","everyMilliseconds":99999999}""", "it must be 100 to 60000")]
    [InlineData("""{"request":"reboot"}""", "no request 'reboot'; there are: status, graph, echo.")]
    [InlineData("""{"request":7}""", "request: that is no request")]
    [InlineData("""{}""", "has a member \"request\"")]
    [InlineData("""null""", "not null")]
    [InlineData("""{"request":"status" """, "that is no request")]
    [InlineData("", "that is no request")]
    public void Request_ThatIsWrong_IsAnsweredWithWhatIsWrongAndTheNextOneIsServed(string request, string answer)
    {
        using var program = new TestProgram();
        using TestClient client = program.Connect();

        Assert.Contains(answer, client.Ask("error", request).GetProperty("text").GetString());
        client.Ask("status", """{"request":"status"}""");
        Assert.Equal(1, program.Diagnostics.Counters.RefusedRequests);
    }

    private static JsonElement Reactor(JsonElement line) => line.GetProperty("reactors")[0];
}
