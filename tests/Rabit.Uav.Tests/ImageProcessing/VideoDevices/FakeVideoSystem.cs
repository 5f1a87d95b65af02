using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;
using System.Threading;
using Rabit.Uav.ImageProcessing.VideoDevices;

namespace Rabit.Uav.Tests.ImageProcessing.VideoDevices;

/// <summary>
/// The kernel with one video device, as a process of 32 or 64 bits sees it: the structures are taken apart by places
/// that are written down here once more. Any thread.
/// </summary>
internal sealed class FakeVideoSystem(int pointerBytes) : IVideoSystem, IDisposable
{
    public const uint StartOfExposure = 0x1_2000;   // and monotonic
    public const uint EndOfFrame = 0x2000;
    public const uint NoClock = 0;
    public const uint Yuyv = 0x5659_5559;
    public const uint Mjpeg = 0x4750_4A4D;

    private const int NoEntry = 2;
    private const int InputOutput = 5;
    private const int TryAgain = 11;
    private const int NoDevice = 19;
    private const int NotADevice = 25;
    private const int BadRequest = 22;

    private readonly object _gate = new();
    private readonly List<IntPtr> _memory = [];
    private readonly Queue<int> _queued = new();
    private readonly Queue<(int Index, int Bytes, uint Flags, long Stamp, uint Sequence)> _done = new();
    private readonly bool _is64 = pointerBytes == 8;
    private bool _isStreaming;

    public int PointerBytes => pointerBytes;

    public string Path { get; set; } = "/dev/video0";

    /// <summary>The error that opening gives; 0 for none.</summary>
    public int OpenError { get; set; }

    public bool IsUnplugged { get; set; }

    /// <summary>Whether its driver is in error, and so always ready with nothing but that (EIO).</summary>
    public bool IsBroken { get; set; }

    public (uint Width, uint Height, uint Format) Offers { get; set; } = (61, 43, Mjpeg);

    public uint RowBytes { get; set; }

    public int BufferBytes { get; set; } = 20_000;

    /// <summary>What the driver says a buffer has; null for what it has.</summary>
    public uint? StatedBytes { get; set; }

    public Dictionary<uint, (int Min, int Max, int Value)> Controls { get; } = [];

    public (uint Numerator, uint Denominator) Period { get; private set; }

    public long Monotonic { get; set; } = 5_000_000_123;

    public int Opened { get; private set; }

    public int Closed { get; private set; }

    public int MappedNow { get; private set; }

    /// <summary>Buffers that the driver has.</summary>
    public int Queued
    {
        get
        {
            lock (_gate)
                return _queued.Count;
        }
    }

    /// <summary>Fills the next buffer; waits for one to be queued.</summary>
    public void Deliver(byte[] picture, uint flags = StartOfExposure, long ageMicroseconds = 0, uint sequence = 0)
    {
        lock (_gate)
        {
            while (!_isStreaming || _queued.Count == 0)
                Monitor.Wait(_gate);
            int index = _queued.Dequeue();
            Marshal.Copy(picture, 0, _memory[index], picture.Length);
            _done.Enqueue((index, picture.Length, flags, Monotonic - ageMicroseconds, sequence));
            Monitor.PulseAll(_gate);
        }
    }

    public void Unplug()
    {
        lock (_gate)
        {
            (IsUnplugged, _isStreaming) = (true, false);
            _queued.Clear();
            _done.Clear();
            Monitor.PulseAll(_gate);
        }
    }

    public int Open(string path)
    {
        if (path != Path || IsUnplugged)
            return -NoEntry;
        if (OpenError != 0)
            return -OpenError;
        Opened++;
        return 7;
    }

    public void Close(int descriptor)
    {
        if (descriptor == 7)
            Closed++;
    }

    public int Wait(int descriptor, int milliseconds)
    {
        lock (_gate)
        {
            if (_done.Count == 0 && !IsUnplugged && !IsBroken)
                Monitor.Wait(_gate, milliseconds);
            return _done.Count > 0 || IsUnplugged || IsBroken ? 1 : 0;
        }
    }

    public IntPtr Map(int descriptor, uint offset, int length)
    {
        MappedNow++;
        return _memory[(int)(offset / 4096)];
    }

    public void Unmap(IntPtr address, int length) => MappedNow--;

    public long MonotonicMicroseconds() => Monotonic;

    public void Dispose()
    {
        foreach (IntPtr memory in _memory)
            Marshal.FreeHGlobal(memory);
        _memory.Clear();
    }

    public int Control(int descriptor, uint request, byte[] argument)
    {
        lock (_gate)
        {
            if (IsUnplugged)
                return -NoDevice;
            int size = (int)((request >> 16) & 0x3FFF);
            if (size != argument.Length)
                throw new InvalidOperationException($"call {request & 0xFF} takes {size} bytes, not {argument.Length}");
            return (request & 0xFF) switch
            {
                0 => Capabilities(argument),
                5 => SetFormat(argument),
                8 => RequestBuffers(argument),
                9 => QueryBuffer(argument),
                15 => QueueBuffer(argument),
                17 => DequeueBuffer(argument),
                18 => Stream(isOn: true),
                19 => Stream(isOn: false),
                22 => SetParameters(argument),
                27 => GetControl(argument),
                28 => SetControl(argument),
                36 => QueryControl(argument),
                _ => -NotADevice,
            };
        }
    }

    private static int Capabilities(byte[] argument)
    {
        Encoding.ASCII.GetBytes("Made-up camera").CopyTo(argument, 16);
        Put(argument, 84, 0x8420_0001);
        Put(argument, 88, 0x0420_0001);
        return 0;
    }

    private int SetFormat(byte[] argument)
    {
        int at = _is64 ? 8 : 4;
        Expect(argument, _is64 ? 208 : 204, 0, 1);
        Put(argument, at, Offers.Width);
        Put(argument, at + 4, Offers.Height);
        Put(argument, at + 8, Offers.Format);
        Put(argument, at + 16, RowBytes);
        Put(argument, at + 20, StatedBytes ?? (uint)BufferBytes);
        return 0;
    }

    private int SetParameters(byte[] argument)
    {
        Period = (Get(argument, 12), Get(argument, 16));
        return 0;
    }

    private int RequestBuffers(byte[] argument)
    {
        Expect(argument, 20, 8, 1);
        _queued.Clear();
        _done.Clear();
        while (_memory.Count < (int)Get(argument, 0))
            _memory.Add(Marshal.AllocHGlobal(BufferBytes));
        return 0;
    }

    private int QueryBuffer(byte[] argument)
    {
        Expect(argument, _is64 ? 88 : 68, _is64 ? 60 : 48, 1);
        Put(argument, _is64 ? 64 : 52, Get(argument, 0) * 4096);
        Put(argument, _is64 ? 72 : 56, StatedBytes ?? (uint)BufferBytes);
        return 0;
    }

    private int QueueBuffer(byte[] argument)
    {
        int index = (int)Get(argument, 0);
        if (_queued.Contains(index))
            return -BadRequest;
        _queued.Enqueue(index);
        Monitor.PulseAll(_gate);
        return 0;
    }

    private int DequeueBuffer(byte[] argument)
    {
        if (IsBroken)
            return -InputOutput;
        if (_done.Count == 0)
            return -TryAgain;
        (int index, int bytes, uint flags, long stamp, uint sequence) = _done.Dequeue();
        Put(argument, 0, (uint)index);
        Put(argument, 8, (uint)bytes);
        Put(argument, 12, flags);
        Put(argument, _is64 ? 24 : 20, (uint)(stamp / 1_000_000));
        Put(argument, _is64 ? 32 : 24, (uint)(stamp % 1_000_000));
        Put(argument, _is64 ? 56 : 44, sequence);
        return 0;
    }

    private int Stream(bool isOn)
    {
        _isStreaming = isOn;
        Monitor.PulseAll(_gate);
        return 0;
    }

    private int QueryControl(byte[] argument)
    {
        if (!Controls.TryGetValue(Get(argument, 0), out (int Min, int Max, int Value) control))
            return -BadRequest;
        Put(argument, 40, (uint)control.Min);
        Put(argument, 44, (uint)control.Max);
        return 0;
    }

    private int SetControl(byte[] argument)
    {
        if (!Controls.TryGetValue(Get(argument, 0), out (int Min, int Max, int Value) control))
            return -BadRequest;
        Controls[Get(argument, 0)] = (control.Min, control.Max, (int)Get(argument, 4));
        return 0;
    }

    private int GetControl(byte[] argument)
    {
        if (!Controls.TryGetValue(Get(argument, 0), out (int Min, int Max, int Value) control))
            return -BadRequest;
        Put(argument, 4, (uint)control.Value);
        return 0;
    }

    private static void Expect(byte[] argument, int length, int at, uint value)
    {
        if (argument.Length != length || Get(argument, at) != value)
            throw new InvalidOperationException($"{argument.Length} bytes with {Get(argument, at)} at {at}");
    }

    private static void Put(byte[] argument, int at, uint value)
        => BinaryPrimitives.WriteUInt32LittleEndian(argument.AsSpan(at), value);

    private static uint Get(byte[] argument, int at) => BinaryPrimitives.ReadUInt32LittleEndian(argument.AsSpan(at));
}
