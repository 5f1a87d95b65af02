using System;
using Rabit.Uav.Communications;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>
/// What holds for every codec of vehicle messages: what is written is read back, and no bytes make it throw or give a
/// message that it would not write itself.
/// </summary>
public abstract class VehicleMessageCodecContract<T>
    where T : struct
{
    private const int Seed = 31;

    private static readonly TimeSpan Now = TimeSpan.FromSeconds(1000);

    private readonly byte[] _buffer = new byte[VehicleMessageRoute.MaxLength];

    private protected abstract IVehicleMessageCodec<T> Codec { get; }

    /// <summary>A valid message.</summary>
    private protected abstract T Random(Random random);

    private protected abstract void AssertEqual(T expected, T actual);

    [Fact]
    public void RoundTrip_RandomMessages_AreTheSameWithinTheForm()
    {
        var random = new Random(Seed);
        for (int i = 0; i < 2000; i++)
        {
            T message = Random(random);
            Assert.True(Codec.TryEncode(message, Now, _buffer, out int length), $"seed {Seed}, message {i}");
            Assert.True(
                Codec.TryDecode(_buffer.AsSpan(0, length), Codec.Version, Now, 7, out T back),
                $"seed {Seed}, message {i}");
            AssertEqual(message, back);
        }
    }

    [Fact]
    public void Encode_BufferTooShort_IsRefused()
    {
        T message = Random(new Random(Seed));
        Assert.True(Codec.TryEncode(message, Now, _buffer, out int length));
        Assert.False(Codec.TryEncode(message, Now, _buffer.AsSpan(0, length - 1), out _));
    }

    [Fact]
    public void Decode_OtherLength_IsRefused()
    {
        T message = Random(new Random(Seed));
        Assert.True(Codec.TryEncode(message, Now, _buffer, out int length));
        Assert.False(Codec.TryDecode(_buffer.AsSpan(0, length - 1), Codec.Version, Now, 7, out _));
        Assert.False(Codec.TryDecode(_buffer.AsSpan(0, length + 1), Codec.Version, Now, 7, out _));
        Assert.False(Codec.TryDecode([], Codec.Version, Now, 7, out _));
    }

    [Fact]
    public void Decode_ChangedBytes_NeverThrowsAndWhatItTakesCanBeWritten()
    {
        var random = new Random(Seed);
        for (int i = 0; i < 50_000; i++)
        {
            Assert.True(Codec.TryEncode(Random(random), Now, _buffer, out int length));
            byte[] bytes = _buffer.AsSpan(0, length).ToArray();
            for (int changes = random.Next(1, 5); changes > 0; changes--)
                bytes[random.Next(length)] = (byte)random.Next(256);
            if (Codec.TryDecode(bytes, Codec.Version, Now, 7, out T taken))
                Assert.True(Codec.TryEncode(taken, Now, _buffer, out _), $"seed {Seed}, message {i}");
        }
    }
}
