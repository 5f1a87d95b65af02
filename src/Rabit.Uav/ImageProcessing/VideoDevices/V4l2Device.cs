using System;
using System.Buffers.Binary;
using System.Runtime.InteropServices;
using System.Text;

namespace Rabit.Uav.ImageProcessing.VideoDevices;

/// <summary>
/// A video device that streams: opened, set, its buffers mapped and queued. Every call that fails is a
/// <see cref="VideoDeviceException"/>; dequeuing, copying and queuing allocate nothing. One thread.
/// </summary>
internal sealed class V4l2Device
{
    private const int WantedBuffers = 4;
    private const int MaxBuffers = 32;
    private const int MaxLost = 30;

    // A driver that says more is wrong: no camera's picture has so many.
    private const uint MaxRowBytes = 1 << 20;
    private const uint MaxPictureBytes = 1 << 28;

    private readonly IVideoSystem _system;
    private readonly V4l2Layout _layout;
    private readonly int _descriptor;
    private readonly byte[] _buffer;
    private readonly byte[] _type = new byte[4];
    private (IntPtr Address, int Length)[] _mapped = [];
    private int _lost;

    /// <exception cref="VideoDeviceException">It cannot be opened, or does not give what is wanted.</exception>
    public V4l2Device(IVideoSystem system, V4l2CameraOptions options)
    {
        _system = system;
        _layout = new V4l2Layout(system.PointerBytes);
        _buffer = new byte[_layout.BufferBytes];
        _descriptor = Check(system.Open(options.Device), "opening");
        try
        {
            ReadCapabilities();
            SetFormat(options);
            SetRate(options);
            Controls = new V4l2Controls(system, _descriptor, options);
            MapBuffers();
            Write(_type, 0, V4l2Layout.Capture);
            Call(V4l2Layout.StreamOn, _type, "starting the stream");
        }
        catch
        {
            Close();
            throw;
        }
    }

    /// <summary>What its maker calls it.</summary>
    public string Card { get; private set; } = string.Empty;

    /// <summary>What was set of exposure and focus.</summary>
    public V4l2Controls Controls { get; }

    /// <summary>From one row of a raw picture to the next.</summary>
    public int RowBytes { get; private set; }

    /// <summary>Whether black is 0 in a raw picture.</summary>
    public bool IsFullRange { get; private set; }

    /// <summary>The most bytes that a picture may have.</summary>
    public int MaxBytes { get; private set; }

    /// <summary>Waits for a picture.</summary>
    /// <returns>Whether there is one, or a fault that <see cref="TryDequeue"/> throws.</returns>
    public bool Wait(int milliseconds)
    {
        int result = _system.Wait(_descriptor, milliseconds);
        return result != -VideoDeviceException.Interrupted && Check(result, "waiting") > 0;
    }

    /// <summary>Takes a picture that is there; it is given back by <see cref="Queue"/>.</summary>
    public bool TryDequeue(out V4l2Buffer buffer)
    {
        buffer = default;
        Array.Clear(_buffer, 0, _buffer.Length);
        Write(_buffer, V4l2Layout.BufferTypeAt, V4l2Layout.Capture);
        Write(_buffer, _layout.MemoryAt, V4l2Layout.Mapped);
        int result = Control(_layout.Dequeue, _buffer);

        if (result == -VideoDeviceException.TryAgain)
            return false;
        if (result == -VideoDeviceException.InputOutput)
            return LosePicture();
        Check(result, "fetching a picture");
        _lost = 0;
        int index = (int)Read(_buffer, 0);
        if (index < 0 || index >= _mapped.Length)
            throw new VideoDeviceException("its driver names a buffer that there is not");
        int used = (int)Math.Min(Read(_buffer, V4l2Layout.BufferUsedAt), (uint)_mapped[index].Length);
        buffer = new V4l2Buffer(
            index, used, Read(_buffer, V4l2Layout.BufferFlagsAt), ReadStamp(), Read(_buffer, _layout.SequenceAt));
        return true;
    }

    /// <summary>Copies a picture.</summary>
    public void Copy(in V4l2Buffer buffer, byte[] to)
        => Marshal.Copy(_mapped[buffer.Index].Address, to, 0, buffer.Bytes);

    /// <summary>Gives a buffer to the driver.</summary>
    public void Queue(int index)
    {
        Fill(index);
        Call(_layout.Queue, _buffer, "queuing a buffer");
    }

    /// <summary>Ends the stream and gives everything back; once.</summary>
    public void Close()
    {
        Write(_type, 0, V4l2Layout.Capture);
        Control(V4l2Layout.StreamOff, _type);
        foreach ((IntPtr address, int length) in _mapped)
        {
            if (address != IntPtr.Zero)
                _system.Unmap(address, length);
        }

        _mapped = [];
        _system.Close(_descriptor);
    }

    // One was lost inside, and the stream goes on; a driver in error says so each time, without any delay.
    private bool LosePicture()
        => ++_lost < MaxLost
            ? false
            : throw new VideoDeviceException(FormattableString.Invariant(
                $"it loses every picture (error {VideoDeviceException.InputOutput} of the operating system)"));

    private void ReadCapabilities()
    {
        byte[] argument = new byte[V4l2Layout.CapabilitiesBytes];
        Call(V4l2Layout.QueryCapabilities, argument, "asking what it is");
        Card = TextOf(argument, V4l2Layout.CardAt, V4l2Layout.CardBytes);
        uint all = Read(argument, V4l2Layout.CapabilitiesAt);
        uint capabilities = (all & V4l2Layout.HasDeviceCapabilities) != 0
            ? Read(argument, V4l2Layout.DeviceCapabilitiesAt)
            : all;
        if ((capabilities & V4l2Layout.Captures) == 0)
            throw new VideoDeviceException((capabilities & V4l2Layout.CapturesPlanes) != 0
                ? $"{Card} gives pictures in several planes, which is not read"
                : $"{Card} is no camera: it captures no pictures");
        if ((capabilities & V4l2Layout.Streams) == 0)
            throw new VideoDeviceException($"{Card} does not stream");
    }

    private void SetFormat(V4l2CameraOptions options)
    {
        uint wanted = options.Format == V4l2PixelFormat.Yuyv ? V4l2Layout.Yuyv : V4l2Layout.Mjpeg;
        byte[] argument = new byte[_layout.FormatBytes];
        int at = _layout.PictureAt;
        Write(argument, 0, V4l2Layout.Capture);
        Write(argument, at, (uint)options.Width);
        Write(argument, at + 4, (uint)options.Height);
        Write(argument, at + 8, wanted);
        Write(argument, at + 12, V4l2Layout.AnyField);
        Call(_layout.SetFormat, argument, "setting the format");
        (uint width, uint height, uint format) = (Read(argument, at), Read(argument, at + 4), Read(argument, at + 8));

        // Some drivers call the same another name.
        if (format == V4l2Layout.Jpeg && wanted == V4l2Layout.Mjpeg)
            format = wanted;
        if (width != options.Width || height != options.Height || format != wanted)
            throw new VideoDeviceException(FormattableString.Invariant(
                $"{Card} gives {width} x {height} {NameOf(format)}; {options.Width} x {options.Height} {NameOf(wanted)}")
                + " is wanted");
        uint rowBytes = Read(argument, at + 16);
        if (format == V4l2Layout.Yuyv && rowBytes > MaxRowBytes)
            throw new VideoDeviceException(FormattableString.Invariant($"{Card} says that a row has {rowBytes} bytes"));
        RowBytes = (int)Math.Max(Math.Min(rowBytes, MaxRowBytes), (uint)options.Width * 2);
        IsFullRange = Read(argument, at + 40) == V4l2Layout.FullRange;
    }

    // What it makes of it is seen by what comes.
    private void SetRate(V4l2CameraOptions options)
    {
        if (options.FramesPerSecond is not { } rate)
            return;
        byte[] argument = new byte[V4l2Layout.ParametersBytes];
        Write(argument, 0, V4l2Layout.Capture);
        Write(argument, V4l2Layout.PeriodNumeratorAt, 1000);
        Write(argument, V4l2Layout.PeriodDenominatorAt, (uint)Math.Round(rate * 1000));
        Control(V4l2Layout.SetParameters, argument);
    }

    private void MapBuffers()
    {
        byte[] request = new byte[V4l2Layout.RequestBytes];
        Write(request, 0, WantedBuffers);
        Write(request, V4l2Layout.RequestTypeAt, V4l2Layout.Capture);
        Write(request, V4l2Layout.RequestMemoryAt, V4l2Layout.Mapped);
        Call(V4l2Layout.RequestBuffers, request, "asking for buffers");
        uint count = Read(request, 0);
        if (count is < 2 or > MaxBuffers)
            throw new VideoDeviceException(FormattableString.Invariant($"{Card} gives {count} buffers"));
        _mapped = new (IntPtr, int)[count];
        for (int index = 0; index < count; index++)
        {
            Fill(index);
            Call(_layout.QueryBuffer, _buffer, "asking for a buffer");
            uint said = Read(_buffer, _layout.LengthAt);
            if (said > MaxPictureBytes)
                throw new VideoDeviceException(FormattableString.Invariant(
                    $"{Card} says that a buffer has {said} bytes"));
            int length = (int)said;
            IntPtr address = _system.Map(_descriptor, Read(_buffer, _layout.OffsetAt), length);
            if (address == IntPtr.Zero)
                throw new VideoDeviceException("its buffers cannot be mapped");
            _mapped[index] = (address, length);
            MaxBytes = Math.Max(MaxBytes, length);
            Queue(index);
        }
    }

    private void Fill(int index)
    {
        Array.Clear(_buffer, 0, _buffer.Length);
        Write(_buffer, 0, (uint)index);
        Write(_buffer, V4l2Layout.BufferTypeAt, V4l2Layout.Capture);
        Write(_buffer, _layout.MemoryAt, V4l2Layout.Mapped);
    }

    private long ReadStamp()
    {
        ReadOnlySpan<byte> stamp = _buffer.AsSpan(_layout.StampAt);
        return _layout.StampNumberBytes == 8
            ? (BinaryPrimitives.ReadInt64LittleEndian(stamp) * 1_000_000)
                + BinaryPrimitives.ReadInt64LittleEndian(stamp.Slice(8))
            : (BinaryPrimitives.ReadInt32LittleEndian(stamp) * 1_000_000L)
                + BinaryPrimitives.ReadInt32LittleEndian(stamp.Slice(4));
    }

    private void Call(uint request, byte[] argument, string doing) => Check(Control(request, argument), doing);

    private int Control(uint request, byte[] argument) => Control(_system, _descriptor, request, argument);

    internal static int Control(IVideoSystem system, int descriptor, uint request, byte[] argument)
    {
        int result;
        do
            result = system.Control(descriptor, request, argument);
        while (result == -VideoDeviceException.Interrupted);
        return result;
    }

    private static int Check(int result, string doing)
        => result >= 0 ? result : throw new VideoDeviceException(-result, doing);

    internal static void Write(byte[] argument, int at, uint value)
        => BinaryPrimitives.WriteUInt32LittleEndian(argument.AsSpan(at), value);

    internal static uint Read(byte[] argument, int at) => BinaryPrimitives.ReadUInt32LittleEndian(argument.AsSpan(at));

    private static string TextOf(byte[] bytes, int at, int length)
    {
        int end = Array.IndexOf(bytes, (byte)0, at, length);
        return Encoding.UTF8.GetString(bytes, at, (end < 0 ? at + length : end) - at);
    }

    private static string NameOf(uint format)
    {
        byte[] name = new byte[4];
        Write(name, 0, format);
        return Encoding.ASCII.GetString(name).Trim();
    }
}
