using System;
using System.Globalization;
using System.IO;
using System.IO.Pipelines;
using System.Net.WebSockets;
using System.Text;
using System.Text.Json;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Tests.Shared;
using Rabit.Uav.Web.Serving;
using Rabit.Uav.Web.State;
using Xunit;

namespace Rabit.Uav.Web.Tests.Serving;

/// <summary>A browser that takes its time gets less, and none of it is kept for it.</summary>
public sealed class SlowBrowserTests
{
    private readonly PageState _state = new();
    private readonly PageCounters _counters = new();

    [Fact]
    public async Task Run_BrowserThatTakesAMessageNowAndThen_GetsTheNewestEachTime()
    {
        using var browser = new PipedBrowser(_state, _counters, TimeSpan.FromMinutes(5));
        for (int value = 0; value <= 2000; value++)
            Post(value);
        int last = -1;
        int messages = 0;
        while (last < 2000)
        {
            last = await browser.ReceiveAsync();
            messages++;
        }

        // What lay in the pipe when it filled, and then the newest.
        Assert.InRange(messages, 1, 100);
        Assert.True(await browser.LeaveAsync());
    }

    [Fact]
    public async Task Run_BrowserThatTakesNothing_IsCutOff()
    {
        using var browser = new PipedBrowser(_state, _counters, TimeSpan.FromMilliseconds(300));
        for (int value = 0; !browser.Ended.IsCompleted; value++)
        {
            Post(value);
            await Task.Yield();
        }

        Assert.False(await browser.Ended);
    }

    private void Post(int value)
    {
        _state.Set("value", Encoding.UTF8.GetBytes(value.ToString(CultureInfo.InvariantCulture)));
        _state.Signal();
    }

    // The two ends of a connection that holds half a kilobyte.
    private sealed class PipedBrowser : IDisposable
    {
        private readonly Pipe _down = new(new PipeOptions(pauseWriterThreshold: 512, resumeWriterThreshold: 256));
        private readonly Pipe _up = new();
        private readonly WebSocket _server;
        private readonly WebSocket _client;

        public PipedBrowser(PageState state, PageCounters counters, TimeSpan sendTimeout)
        {
            _server = WebSocket.CreateFromStream(
                new TwoWay(_up.Reader, _down.Writer), new WebSocketCreationOptions { IsServer = true });
            _client = WebSocket.CreateFromStream(
                new TwoWay(_down.Reader, _up.Writer), new WebSocketCreationOptions());
            Ended = new BrowserSession(_server, state, counters, sendTimeout).RunAsync(CancellationToken.None);
        }

        public Task<bool> Ended { get; }

        public async Task<int> ReceiveAsync()
        {
            var buffer = new byte[4000];
            using var late = new CancellationTokenSource(TestTimeout.Limit);
            ValueWebSocketReceiveResult received = await _client.ReceiveAsync(buffer.AsMemory(), late.Token);
            using JsonDocument message = JsonDocument.Parse(buffer.AsMemory(0, received.Count));
            return message.RootElement.GetProperty("set").GetProperty("value").GetInt32();
        }

        public async Task<bool> LeaveAsync()
        {
            await _client.CloseOutputAsync(WebSocketCloseStatus.NormalClosure, null, CancellationToken.None);
            return await Ended.WaitAsync(TestTimeout.Limit);
        }

        public void Dispose()
        {
            _server.Dispose();
            _client.Dispose();
        }
    }

    private sealed class TwoWay(PipeReader reader, PipeWriter writer) : Stream
    {
        private readonly Stream _reader = reader.AsStream();
        private readonly Stream _writer = writer.AsStream();

        public override bool CanRead => true;

        public override bool CanSeek => false;

        public override bool CanWrite => true;

        public override long Length => throw new NotSupportedException();

        public override long Position
        {
            get => throw new NotSupportedException();
            set => throw new NotSupportedException();
        }

        public override void Flush() => _writer.Flush();

        public override Task FlushAsync(CancellationToken cancellationToken) => _writer.FlushAsync(cancellationToken);

        public override int Read(byte[] buffer, int offset, int count) => _reader.Read(buffer, offset, count);

        public override ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellationToken = default)
            => _reader.ReadAsync(buffer, cancellationToken);

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Write(byte[] buffer, int offset, int count) => _writer.Write(buffer, offset, count);

        public override ValueTask WriteAsync(ReadOnlyMemory<byte> buffer, CancellationToken cancellationToken = default)
            => _writer.WriteAsync(buffer, cancellationToken);
    }
}
