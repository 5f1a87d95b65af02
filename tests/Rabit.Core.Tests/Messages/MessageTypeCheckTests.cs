using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Globalization;
using System.Threading.Tasks;
using Rabit.Core.Messages;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Messages;

/// <summary>Contract 2.5: which types may be messages, and the field that is named where one may not.</summary>
public sealed class MessageTypeCheckTests
{
    public static TheoryData<Type> Accepted => new()
    {
        typeof(int), typeof(double), typeof(bool), typeof(char), typeof(IntPtr), typeof(DayOfWeek), typeof(string),
        typeof(decimal), typeof(DateTime), typeof(DateTimeOffset), typeof(TimeSpan), typeof(Guid), typeof(Version),
        typeof(Uri), typeof(TimeZoneInfo),
        typeof(int?), typeof(Plain?), typeof((int, string)), typeof(KeyValuePair<string, int>),
        typeof(Plain), typeof(Nested), typeof(Generic<Plain>), typeof(SealedRecord), typeof(RecordStruct),
        typeof(Fixed),
        typeof(ReadOnlyClass), typeof(Node), typeof(Derived), typeof(HoldsImmutables), typeof(StaticsOnly),
        typeof(ImmutableArray<int>), typeof(ImmutableList<string>), typeof(ImmutableDictionary<string, Plain>),
        typeof(Tree),
        typeof(ManagerStatus), typeof(MessageStamp), typeof(QueueCounters), typeof(Vouched), typeof(HoldsVouched),
        typeof(IVouched),
    };

    public static TheoryData<Type, string> Refused => new()
    {
        { typeof(int[]), "Int32[]" },
        { typeof(HoldsArray), "HoldsArray.Samples is an array (Double[])" },
        { typeof(Deep), "Deep.Middle.Inner.Samples is an array (Double[])" },
        { typeof(Generic<HoldsArray>), "Generic<HoldsArray>.Value.Samples is an array (Double[])" },
        { typeof(HoldsArray?), "Nullable<HoldsArray>.value.Samples" },
        { typeof((int, int[])), "ValueTuple<Int32, Int32[]>.Item2 is an array (Int32[])" },
        { typeof(HoldsProperty), "HoldsProperty.Samples is an array" },
        {
            typeof(Unsealed),
            "Unsealed is of class Unsealed, which is not sealed: a derived one may hold something mutable."
        },
        { typeof(UnsealedRecord), "which is not sealed" },
        { typeof(HoldsUnsealed), "HoldsUnsealed.Part is of class Unsealed, which is not sealed" },
        { typeof(MutableClass), "MutableClass.Count can be changed" },
        { typeof(MutableProperty), "MutableProperty.Count can be changed" },
        { typeof(MutableBase), "MutableBase.Count can be changed" },
        { typeof(HoldsMutable), "HoldsMutable.Part.Count can be changed" },
        { typeof(Action), "delegate (Action)" },
        { typeof(HoldsDelegate), "HoldsDelegate.Call is a delegate (Func<Int32>)" },
        { typeof(IDisposable), "IDisposable, which may hold something mutable" },
        { typeof(object), "Object, which may hold something mutable" },
        { typeof(HoldsInterface), "HoldsInterface.Numbers is of type IReadOnlyList<Int32>" },
        { typeof(List<int>), "which is not sealed" },
        { typeof(Tuple<int, string>), "which is not sealed" },
        { typeof(Task), "which is not sealed" },
        { typeof(ReadOnlyMemory<byte>), "which may hold something mutable" },
        { typeof(ImmutableList<int[]>), "ImmutableList<Int32[]><Int32[]> is an array" },
        { typeof(ImmutableDictionary<string, MutableClass>), "<MutableClass>.Count can be changed" },
        { typeof(ImmutableList<int>.Builder), "can be changed" },
        { typeof(IImmutableList<int>), "which may hold something mutable" },
        { typeof(HoldsPointer), "HoldsPointer.Memory is a pointer" },

        { typeof(BufferLease),
            "BufferLease is a BufferLease: a buffer has one owner at a time, and travels by queue." },
        { typeof(HoldsBuffer),
            "HoldsBuffer.Pixels is a BufferLease: a buffer has one owner at a time, and travels by queue." },

        // A culture can be changed unless it was made read only.
        { typeof(CultureInfo), "CultureInfo" },
        { typeof(FromVouched), "can be changed" },
        { typeof(VouchedList<int[]>), "VouchedList<Int32[]><Int32[]> is an array" },
    };

    [Theory, Trait("Clause", "2.5")]
    [MemberData(nameof(Accepted))]
    public void FindFault_TypeWhoseCopiesAreIndependent_FindsNone(Type type)
        => Assert.Null(MessageTypeCheck.FindFault(type));

    [Theory, Trait("Clause", "2.5")]
    [MemberData(nameof(Refused))]
    public void FindFault_TypeWhoseCopiesShareSomething_NamesTheField(Type type, string expected)
        => Assert.Contains(expected, MessageTypeCheck.FindFault(type), StringComparison.Ordinal);

    /// <summary>They are of the library of immutable collections, but not all runtimes come with them.</summary>
    [Fact, Trait("Clause", "2.5")]
    public void FindFault_FrozenCollection_FindsNone()
    {
        Type? set = typeof(ImmutableArray<int>).Assembly.GetType("System.Collections.Frozen.FrozenSet`1");
        if (set is null)
            return;

        Assert.Null(MessageTypeCheck.FindFault(set.MakeGenericType(typeof(int))));
        Assert.Contains(
            "FrozenSet<Int32[]><Int32[]> is an array", MessageTypeCheck.FindFault(set.MakeGenericType(typeof(int[]))),
            StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "2.5")]
    public void FindFault_TypeThatTheWorkspaceTrusts_FindsNone()
    {
        Type[] trusted = [typeof(MutableClass), typeof(Stranger<>), typeof(IDisposable)];

        foreach (Type type in new[]
        {
            typeof(MutableClass), typeof(HoldsMutable), typeof(Stranger<string>), typeof(IDisposable),
            typeof(Generic<Stranger<int>>)
        })
        {
            Assert.NotNull(MessageTypeCheck.FindFault(type));
            Assert.Null(MessageTypeCheck.FindFault(type, trusted: trusted));
        }

        Assert.Contains(
            "<Int32[]> is an array", MessageTypeCheck.FindFault(typeof(Stranger<int[]>), trusted: trusted),
            StringComparison.Ordinal);
        Assert.Contains(
            "is an array", MessageTypeCheck.FindFault(typeof(HoldsArray), trusted: trusted), StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "2.5"), Trait("Clause", "4.2")]
    public void TrustImmutable_BeforeTheStart_LetsTheTypeBeAMessageOfThisWorkspaceOnly()
    {
        foreach (bool trusts in new[] { true, false })
        {
            using var run = new TestRun(TimeKind.Virtual);
            run.Add("m").Publish("part", new HoldsMutable { Part = new MutableClass() });
            if (trusts)
                run.Reactor.Workspace.TrustImmutable(typeof(MutableClass));
            if (!trusts)
            {
                Assert.Contains(
                    "HoldsMutable.Part.Count", Assert.Throws<RabitWiringException>(run.Start).Message,
                    StringComparison.Ordinal);
                continue;
            }

            run.Start();
            string message = Assert.Throws<InvalidOperationException>(
                () => run.Reactor.Workspace.TrustImmutable(typeof(Plain))).Message;
            Assert.Contains("Plain", message, StringComparison.Ordinal);
        }
    }

    [Fact, Trait("Clause", "2.5"), Trait("Clause", "4.2")]
    public void Start_MessageOfARefusedType_NamesMessageAndField()
    {
        var reactor = new RabitReactor(new VirtualTime());
        reactor.Workspace.Publish<HoldsArray>("spectrum");

        IReadOnlyList<string> faults = Assert.Throws<RabitWiringException>(reactor.Start).Faults;

        Assert.Contains(faults, f => f.StartsWith("Message 'spectrum': HoldsArray.Samples", StringComparison.Ordinal));
    }

    // Only the shapes of these types matter.
#pragma warning disable CS0649, CA1051, CA1823, CA1852, IDE0044, IDE0051, CS0169, CS0414
#pragma warning disable CA1812, CA2211, MA0069, MA0036, CA1052 // Same.
    internal struct Plain
    {
        public int Number;
        public double Height { get; set; }
    }

    internal struct Nested
    {
        public Plain Part;
        public string? Name;
    }

    internal struct Generic<T>
    {
        public T Value;
    }

    internal sealed record SealedRecord(int Number, string Name, ImmutableArray<Plain> Parts);

    internal readonly record struct RecordStruct(int Number, string Name);

    internal unsafe struct Fixed
    {
        public fixed byte Text[50];
    }

    internal sealed class ReadOnlyClass(int number)
    {
        public readonly int Number = number;
        public Plain Part { get; } = new Plain { Number = number };
    }

    internal sealed class Node(Node? next)
    {
        public readonly Node? Next = next;
    }

    internal sealed class Tree(ImmutableList<Tree> children)
    {
        public ImmutableList<Tree> Children { get; } = children;
    }

    internal abstract class ValidBase
    {
        protected readonly int Number = 1;
    }

    internal sealed class Derived : ValidBase;

    internal struct HoldsImmutables
    {
        public ImmutableArray<string> Names;
        public ImmutableSortedDictionary<int, Version> Versions;
    }

    internal sealed class StaticsOnly
    {
        public static int[] Shared = [1];
    }

    internal struct HoldsArray
    {
        public double[] Samples;
    }

    internal struct Deep
    {
        public Middle Middle;
    }

    internal struct Middle
    {
        public HoldsArray Inner;
    }

    internal struct HoldsProperty
    {
        public double[] Samples { get; set; }
    }

    internal class Unsealed
    {
        public readonly int Number = 1;
    }

    internal record UnsealedRecord(int Number);

    internal struct HoldsUnsealed
    {
        public Unsealed Part;
    }

    internal sealed class MutableClass
    {
        public int Count;
    }

    internal sealed class MutableProperty
    {
        public int Count { get; set; }
    }

    internal abstract class CountingBase
    {
        protected int Count;
    }

    internal sealed class MutableBase : CountingBase;

    internal struct HoldsMutable
    {
        public MutableClass Part;
    }

    [TrustedImmutable]
    internal class Vouched
    {
        public int[] Numbers = [1, 2];
    }

    internal sealed class FromVouched : ValidSibling;

    internal class ValidSibling : Vouched
    {
        public int[] More = [];
    }

    [TrustedImmutable]
    internal interface IVouched;

    internal struct HoldsVouched
    {
        public Vouched Part;
        public IVouched Other;
    }

    [TrustedImmutable]
    internal sealed class VouchedList<T>
    {
        public T[] Items = [];
    }

    internal sealed class Stranger<T>
    {
        public T? Value;
    }

    internal struct HoldsDelegate
    {
        public Func<int> Call;
    }

    internal struct HoldsInterface
    {
        public IReadOnlyList<int> Numbers;
    }

    internal struct HoldsBuffer
    {
        public BufferLease Pixels { get; set; }
    }

    internal unsafe struct HoldsPointer
    {
        public byte* Memory;
    }
#pragma warning restore
}
