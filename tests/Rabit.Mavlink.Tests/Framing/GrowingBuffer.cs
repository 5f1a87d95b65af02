using System;
using System.Buffers;
using System.Linq;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>A buffer that grows; net472 has none.</summary>
internal sealed class GrowingBuffer : IBufferWriter<byte>
{
    private byte[] _bytes = [];
    private int _count;

    public byte[] Written => _bytes.Take(_count).ToArray();

    public void Advance(int count) => _count += count;

    public Memory<byte> GetMemory(int sizeHint = 0)
    {
        Array.Resize(ref _bytes, _count + Math.Max(sizeHint, 1));
        return _bytes.AsMemory(_count);
    }

    public Span<byte> GetSpan(int sizeHint = 0) => GetMemory(sizeHint).Span;
}
