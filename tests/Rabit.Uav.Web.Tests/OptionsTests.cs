using System;
using System.IO;
using System.Net;
using Xunit;

namespace Rabit.Uav.Web.Tests;

public sealed class OptionsTests : IDisposable
{
    private readonly string _file = Path.Combine(Path.GetTempPath(), "rabit-token-" + Guid.NewGuid().ToString("N"));

    public void Dispose() => File.Delete(_file);

    [Fact]
    public void LivePage_OtherAddressThanLoopback_NeedsAToken()
    {
        var options = new LivePageOptions { EndPoint = new IPEndPoint(IPAddress.Any, 0) };
        ArgumentException fault = Assert.Throws<ArgumentException>(() => new LivePage(options));
        Assert.Contains("0.0.0.0:0 can be reached from other computers", fault.Message, StringComparison.Ordinal);
        options.Token = LivePageToken.Create("0123456789abcdef");
        Assert.NotNull(new LivePage(options));
    }

    [Fact]
    public void LivePage_SeveralFaults_AreAllNamed()
    {
        ArgumentException fault = Assert.Throws<ArgumentException>(() => new LivePage(
            new LivePageOptions { MaxBrowsers = 0, HostNames = [" "], TileFolder = "/nowhere/tiles" }));
        foreach (string name in new[] { "MaxBrowsers: it is 0", "HostNames: ", "TileFolder: there is no folder /nowhere/tiles" })
            Assert.Contains(name, fault.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("0123456789abcdef")]
    [InlineData("0123456789abcdef\n")]
    [InlineData("0123456789abcdef\r\nmore")]
    public void ReadFile_FirstLine_IsTheToken(string content)
    {
        Write(content);
        LivePageToken token = LivePageToken.ReadFile(_file);
        Assert.True(token.IsEqual("0123456789abcdef"));
        Assert.False(token.IsEqual("0123456789abcdeF"));
        Assert.False(token.IsEqual(""));
        Assert.False(token.IsEqual(new string('ก', 10_000)));
        Assert.DoesNotContain("0123", token.ToString(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("", "it has 0 characters")]
    [InlineData("short", "it has 5 characters; 16 to 256 are needed.")]
    [InlineData("0123456789 abcdef", "no blanks")]
    [InlineData("0123456789abcdefé", "printable ASCII")]
    public void ReadFile_NoToken_IsRefusedWithoutSayingIt(string content, string fault)
    {
        Write(content);
        ArgumentException e = Assert.Throws<ArgumentException>(() => LivePageToken.ReadFile(_file));
        Assert.Contains(_file, e.Message, StringComparison.Ordinal);
        Assert.Contains(fault, e.Message, StringComparison.Ordinal);
        if (content.Length > 5)
            Assert.DoesNotContain(content, e.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void ReadFile_ThatEveryoneMayRead_IsRefused()
    {
        Write("0123456789abcdef");
        if (OperatingSystem.IsWindows())
            return;
        File.SetUnixFileMode(_file, UnixFileMode.UserRead | UnixFileMode.OtherRead);
        Assert.Contains(
            "chmod 640", Assert.Throws<ArgumentException>(() => LivePageToken.ReadFile(_file)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void ReadFile_ThatIsNotThere_IsNamed()
        => Assert.Contains(
            _file, Assert.Throws<ArgumentException>(() => LivePageToken.ReadFile(_file)).Message,
            StringComparison.Ordinal);

    private void Write(string content)
    {
        File.WriteAllText(_file, content);
        if (!OperatingSystem.IsWindows())
            File.SetUnixFileMode(_file, UnixFileMode.UserRead | UnixFileMode.UserWrite);
    }
}
