using System;
using System.IO;
using System.Linq;
using System.Net.Sockets;
using System.Text.Json;
using Rabit.Core;
using Rabit.Diagnostics.Protocol;
using Xunit;

namespace Rabit.Diagnostics.Tests;

/// <summary>The socket: where it is, whose it is, and what is left of it.</summary>
public sealed class SocketTests
{
    private const UnixFileMode Own = UnixFileMode.UserRead | UnixFileMode.UserWrite;

    [Fact]
    public void Open_InAFolderThatIsNotThere_MakesItForThisUserAlone()
    {
        using var program = new TestProgram();

        Assert.Null(program.Diagnostics.Fault);
        string path = program.Diagnostics.SocketPath!;
        Assert.Equal(Path.Combine(program.Folder, $"test-{Environment.ProcessId}.sock"), path);
        Assert.Equal(Own | UnixFileMode.UserExecute, File.GetUnixFileMode(program.Folder));
        Assert.Equal(Own, File.GetUnixFileMode(path));
    }

    [Fact]
    public void Open_InAFolderThatOthersMayRead_ClosesIt()
    {
        using var folder = new TemporaryFolder();
        Directory.CreateDirectory(folder.Sockets);
        File.SetUnixFileMode(folder.Sockets, Own | UnixFileMode.UserExecute | UnixFileMode.OtherRead);
        using RabitDiagnostics diagnostics = Open(folder.Sockets);

        Assert.Null(diagnostics.Fault);
        Assert.Equal(Own | UnixFileMode.UserExecute, File.GetUnixFileMode(folder.Sockets));
    }

    [Fact]
    public void Open_ThroughALinkOrWithoutAParentOrTooLong_SaysWhyAndThrowsNothing()
    {
        using var folder = new TemporaryFolder();
        Directory.CreateDirectory(folder.Path + "/elsewhere");
        Directory.CreateSymbolicLink(folder.Sockets, folder.Path + "/elsewhere");

        AssertFault("is not a folder of this user", folder.Sockets);
        AssertFault("there is no folder", folder.Path + "/not/there");
        AssertFault("too long", folder.Path + "/" + new string('x', 100));
    }

    [Fact]
    public void Open_ASecondTimeInOneProcess_IsFoundUnderANumberedName()
    {
        using var program = new TestProgram();
        using RabitDiagnostics second = Open(program.Folder);

        Assert.EndsWith($"test.2-{Environment.ProcessId}.sock", second.SocketPath);
        Assert.Equal("test.2", NameAt(second.SocketPath!));
        Assert.Equal("test", NameAt(program.Diagnostics.SocketPath!));
    }

    [Fact]
    public void Open_NameThatIsNoFileName_IsCleaned()
    {
        using var folder = new TemporaryFolder();
        using RabitDiagnostics diagnostics = RabitDiagnostics.Open(
            new DiagnosticsOptions { Program = "../a b/" + new string('n', 100), Folder = folder.Sockets },
            new RabitReactor());

        Assert.Equal(
            $"_.._a_b_{new string('n', 33)}-{Environment.ProcessId}.sock", Path.GetFileName(diagnostics.SocketPath));
    }

    [Fact]
    public void Open_SocketsOfEndedProcesses_RemovesThemAndNoOthers()
    {
        using var folder = new TemporaryFolder();
        Directory.CreateDirectory(folder.Sockets);
        string stale = LeaveSocket(folder.Sockets, $"gone-{int.MaxValue}.sock");
        string ofThisNumber = LeaveSocket(folder.Sockets, $"test-{Environment.ProcessId}.sock");
        string other = LeaveSocket(folder.Sockets, "other-1.sock");
        string file = Path.Combine(folder.Sockets, "note.txt");
        File.WriteAllText(file, "mine");

        using RabitDiagnostics diagnostics = Open(folder.Sockets);

        Assert.False(File.Exists(stale));
        Assert.True(File.Exists(other));
        Assert.True(File.Exists(file));
        Assert.Equal(ofThisNumber, diagnostics.SocketPath);
        new TestClient(ofThisNumber).Read("hello");
    }

    [Fact]
    public void Dispose_WithClientsConnected_DisconnectsThemAndRemovesTheSocket()
    {
        using var program = new TestProgram();
        string path = program.Diagnostics.SocketPath!;
        using TestClient idle = program.Connect();
        using TestClient streaming = program.Connect();
        streaming.Ask("status", """{"request":"status","everyMilliseconds":60000}""");

        program.Diagnostics.Dispose();
        program.Diagnostics.Dispose();

        Assert.Null(idle.Read());
        Assert.Null(streaming.Read());
        Assert.False(File.Exists(path));
        Assert.Equal(0, program.Diagnostics.Counters.Connected);
    }

    [Fact]
    public void Hello_Always_SaysProtocolProgramAndReactors()
    {
        using var program = new TestProgram(starts: false);
        using var client = new TestClient(program.Diagnostics.SocketPath!);

        JsonElement hello = client.Read("hello");

        Assert.Equal(1, hello.GetProperty("protocol").GetInt32());
        Assert.Equal("test", hello.GetProperty("program").GetString());
        Assert.Equal(Environment.ProcessId, hello.GetProperty("processId").GetInt32());
        Assert.Equal("main", hello.GetProperty("reactors")[0].GetString());
        Assert.NotEmpty(hello.GetProperty("version").GetString()!);
    }

    [Theory]
    [InlineData("/run/user/7", "/run/user/7/rabit")]
    [InlineData("relative", null)]
    [InlineData("", null)]
    [InlineData(null, null)]
    public void FolderOfTheSession_IsInAnAbsoluteRuntimeDirectoryAlone(string? variable, string? folder)
    {
        Assert.Equal(folder, DiagnosticsFolder.OfSession(variable));
        Assert.Equal("/tmp/rabit-7", DiagnosticsFolder.WithoutSession(7));
    }

    [Fact]
    public void Open_WithNull_Throws()
    {
        Assert.Throws<ArgumentException>(() => RabitDiagnostics.Open([null!]));
        Assert.Throws<ArgumentNullException>(
            () => RabitDiagnostics.Open((DiagnosticsOptions)null!, new RabitReactor()));
    }

    private static RabitDiagnostics Open(string folder)
        => RabitDiagnostics.Open(new DiagnosticsOptions { Program = "test", Folder = folder }, new RabitReactor());

    private static string NameAt(string path)
    {
        using var client = new TestClient(path);
        return client.Read("hello").GetProperty("program").GetString()!;
    }

    private static void AssertFault(string text, string folder)
    {
        using RabitDiagnostics diagnostics = Open(folder);
        Assert.Contains(text, diagnostics.Fault);
        Assert.Null(diagnostics.SocketPath);
        Assert.Equal(default, diagnostics.Counters);
    }

    // As a process leaves it that was killed: the file is there, and none listens.
    private static string LeaveSocket(string folder, string name)
    {
        string path = Path.Combine(folder, name);
        string moved = path + ".moved";
        using (var socket = new Socket(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified))
        {
            socket.Bind(new UnixDomainSocketEndPoint(path));
            File.Move(path, moved);   // a socket that is disposed takes its file along
        }

        File.Move(moved, path);
        return path;
    }
}
