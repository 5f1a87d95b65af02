using System.Threading.Tasks;
using Xunit;

namespace Rabit.Core.Tests.Analyzers;

/// <summary>RABIT0008: leases of buffers after a push.</summary>
public sealed class LeaseAnalyzerTests
{
    private const string Types = "public struct Picture { public BufferLease Pixels; public int Width; }";

    [Theory]
    [InlineData("_ = _leases.Push(lease); lease.Span[0] = 1;", "lease")]
    [InlineData("_ = _leases.Push(lease); Use(lease);", "lease")]
    [InlineData("_ = _pictures.Push(new Picture { Pixels = lease }); Use(lease);", "lease")]
    [InlineData("if (_leases.Push(lease) == PushResult.Rejected) lease.Dispose(); Use(lease);", "lease")]
    [InlineData("if (_leases.Push(lease) == PushResult.Rejected) return; Use(lease);", "lease")]
    [InlineData("if (lease.IsEmpty) { _ = _leases.Push(lease); } Use(lease);", "lease")]
    [InlineData("_ = _pictures.Push(picture); Use(picture.Pixels);", "picture")]
    [InlineData("_ = _leases.Push(lease); if (_count > 0) { Use(lease); }", "lease")]
    [InlineData("switch (_count) { case 1: _ = _leases.Push(lease); break; } Use(lease);", "lease")]
    [InlineData("switch (_count) { case 1: _ = _leases.Push(lease); Use(lease); break; }", "lease")]
    [InlineData("_ = _leases.Push(lease); lease.HandTo(\"me\");", "lease")]
    public async Task Rabit0008_UseAfterPush_IsFound(string code, string found)
        => Assert.Equal([$"RABIT0008 at {found}"], await Report(code));

    [Theory]
    [InlineData("Use(lease); _ = _leases.Push(lease);")]
    [InlineData("if (_leases.Push(lease) == PushResult.Rejected) lease.Dispose();")]
    [InlineData("if (_leases.Push(lease) == PushResult.Rejected) Use(lease);")]
    [InlineData("_ = _leases.Push(lease); lease.Dispose();")]
    [InlineData("_ = _leases.Push(lease); if (lease.IsEmpty) return;")]
    [InlineData("_ = _leases.Push(lease); lease = default; Use(lease);")]
    [InlineData("_ = _leases.Push(lease); _pool.TryRent(\"me\", out lease); Use(lease);")]
    [InlineData("if (_count > 0) { _ = _leases.Push(lease); return; } Use(lease);")]
    [InlineData("if (_count > 0) { _ = _leases.Push(lease); } else { Use(lease); }")]
    [InlineData("PushResult result = _leases.Push(lease); if (result == PushResult.Rejected) Use(lease);")]
    [InlineData("for (int i = 0; i < 2; i++) { if (i == 1) { _ = _leases.Push(lease); break; } Use(lease); }")]
    [InlineData("_ = _counts.Push(picture.Width); Use(picture.Pixels);")]
    [InlineData("if (_leases.Push(lease) != PushResult.Rejected) return; Use(lease);")]
    [InlineData("if (_leases.Push(lease) is not PushResult.Rejected) return; Use(lease);")]
    [InlineData("if (!(_leases.Push(lease) == PushResult.Rejected)) return; Use(lease);")]
    [InlineData("if (_count > 0 && _leases.Push(lease) == PushResult.Queued) return; Use(lease);")]
    [InlineData("_ = _pictures.Push(picture); _count = picture.Width;")]
    [InlineData("_ = _pictures.Push(picture); picture.Pixels = default; Use(picture.Pixels);")]
    [InlineData("int x; _ = _leases.Push(lease); (lease, x) = (default, 1); Use(lease);")]
    [InlineData("_ = _leases.Push(lease); if (lease is { IsEmpty: true }) return;")]
    [InlineData("_ = _leases.Push(lease); BufferLease copy = lease; copy.Dispose();")]
    [InlineData("switch (_count) { case 1: _ = _leases.Push(lease); return; default: break; } Use(lease);")]
    [InlineData("Action later = () => { _ = _leases.Push(lease); }; Use(lease);")]
    public async Task Rabit0008_UseByItsOwner_IsNotFound(string code) => Assert.Empty(await Report(code));

    private static Task<string[]> Report(string code) => AnalyzedManager.Report(
        $$"""
        private readonly QueueSender<BufferLease> _leases = null!;
        private readonly QueueSender<Picture> _pictures = null!;
        private readonly QueueSender<int> _counts = null!;
        private readonly BufferPool _pool = null!;
        private int _count;
        protected override void ExecuteUnitOfWork() => _count++;
        private static void Use(BufferLease lease) { }
        private void Do(BufferLease lease, Picture picture)
        {
            {{code}}
        }
        """,
        Types);
}
