using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Messages;
using Rabit.Core.Tests.Queues;
using Rabit.Core.WakeUp;
using Xunit;

namespace Rabit.Core.Tests.Messages;

/// <summary>The slots of a message on one thread: others act in front of each of its accesses.</summary>
public sealed class SlotPoolTests
{
    private const int Spares = 2;

    // How many accesses a post or a fetch has where nothing is in its way, by the kind; and one more.
    private static int PointsOfLoad(int tries) => tries == 0 ? 7 : 3;

    private static int PointsOfStore(int tries) => tries == 0 ? 5 : 7;

    /// <summary>Whether there is one poster, and how often a fetch tries before it pins.</summary>
    public static TheoryData<bool, int> Ways()
        => new() { { true, 1 }, { true, 4 }, { false, 0 }, { false, 1 }, { false, 4 } };

    [Theory, Trait("Clause", "2.4")]
    [MemberData(nameof(Ways))]
    public void Load_PostsInFrontOfEachAccess_IsOneOfThemWhole(bool isAlone, int tries)
    {
        int last = PointsOfLoad(tries);
        for (int point = 1; point <= last; point++)
        {
            foreach (int posts in new[] { 1, Spares, Spares + 1, 10 })
            {
                var message = new Message<HeldUpPoints>(isAlone, tries);
                message.Post(1);
                HeldUpPoints.HoldUpAt(point, () => message.PostMany(posts));

                var value = default(NumberCopier);
                int version = message.Load(ref value);

                Assert.Equal(version, value.Number);
                Assert.InRange(version, 1, message.Posted);
                HeldUpPoints.HoldUpAt(0, () => { });
                message.AssertLatest(message.Posted);
                Assert.Equal(point != last, message.Posted > 1);
            }
        }
    }

    /// <summary>Neither side starves the other, however fast the posts come: each copy is overwritten.</summary>
    [Theory, Trait("Clause", "2.4")]
    [MemberData(nameof(Ways))]
    public void Load_PostsComeAllTheWayAroundInEachCopy_PinsAfterTheLastTry(bool isAlone, int tries)
    {
        const int AllTheWayAround = Spares + 1;
        var message = new Message<SyncPoints>(isAlone, tries);
        message.Post(1);
        int copies = 0;
        var value = new NumberCopier(0, () =>
        {
            Assert.True(++copies <= tries + 1, "The fetch goes on copying what posts spoil.");
            message.PostMany(AllTheWayAround);
        });

        int version = message.Load(ref value);

        Assert.Equal(tries + 1, copies);
        Assert.Equal(1 + (tries * AllTheWayAround), version);   // the latest when it pinned
        Assert.Equal(version, value.Number);
        Assert.Equal(version + AllTheWayAround, message.Posted);
        message.AssertLatest(message.Posted);
    }

    /// <summary>
    /// Lock-free: a pin looks for the latest slot once more for each post that comes between its look and its check,
    /// and for nothing else.
    /// </summary>
    [Theory, Trait("Clause", "2.4")]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(50)]
    public void Pin_PostsInFrontOfEachCheck_LooksOnceMoreForEach(int posts)
    {
        const int UpToTheCheck = 4;              // the look, the pin (a read and a swap), the check
        const int Again = 2 + UpToTheCheck;      // letting go comes first
        var message = new Message<HeldUpPoints>(isAlone: false, tries: 0);
        message.Post(1);
        int left = posts;
        bool looksOn = false;
        void Meanwhile()
        {
            if (left-- == 0)
            {
                looksOn = true;
                return;
            }

            message.Post(message.Posted + 1);
            HeldUpPoints.HoldUpAt(left > 0 ? Again : Again + 1, Meanwhile);
        }

        HeldUpPoints.HoldUpAt(posts > 0 ? UpToTheCheck : UpToTheCheck + 1, Meanwhile);
        NumberSlot slot = message.Pin();
        HeldUpPoints.HoldUpAt(0, () => { });

        Assert.False(looksOn, "The fetch looks again without a post.");
        Assert.Equal(0, left);
        Assert.Equal(1 + posts, slot.Number);
        Assert.Equal(1 + posts, message.Posted);
    }

    [Theory, Trait("Clause", "2.3")]
    [InlineData(0)]
    [InlineData(4)]
    public void Store_OthersPostInFrontOfEachAccess_EachHasItsVersion(int tries)
    {
        int last = PointsOfStore(tries);
        for (int point = 1; point <= last; point++)
        {
            var message = new Message<HeldUpPoints>(isAlone: false, tries);
            SpareSlots others = message.NewSpares();
            var versions = new List<int>();
            HeldUpPoints.HoldUpAt(point, () => versions.Add(message.Store(2, others)));

            versions.Add(message.Store(1, message.Spares));

            Assert.Equal(Enumerable.Range(1, versions.Count), versions);
            Assert.Equal(point != last, HeldUpPoints.WasHeldUp);
            HeldUpPoints.HoldUpAt(0, () => { });
        }
    }

    [Theory, Trait("Clause", "2.4")]
    [InlineData(true, 4)]
    [InlineData(false, 0)]
    public void Store_AllSparesArePinned_TakesOneMoreAndWritesNoneOfThem(bool isAlone, int tries)
    {
        const int Fetchers = 5;
        var message = new Message<SyncPoints>(isAlone, tries);
        var pinned = new List<NumberSlot>();
        for (int number = 1; number <= Fetchers; number++)
        {
            message.Post(number);
            pinned.Add(message.Pin());
        }

        message.PostMany(10);

        Assert.Equal(Enumerable.Range(1, Fetchers), pinned.Select(s => s.Number));
        int slots = message.SlotsMade;
        pinned.ForEach(SlotPool<NumberSlot, SyncPoints>.Unpin);
        message.PostMany(100);
        Assert.Equal(slots, message.SlotsMade);
        Assert.InRange(slots, Fetchers + 2, Fetchers + 1 + Spares);
        message.AssertLatest(message.Posted);
    }

    /// <summary>A message with numbers that count its posts.</summary>
    private sealed class Message<TSync>
        where TSync : struct, ISyncPoints
    {
        private readonly SlotPool<NumberSlot, TSync> _pool;
        private long _latest;

        public Message(bool isAlone, int tries)
        {
            _pool = new SlotPool<NumberSlot, TSync>(NewSlot(), NewSlot, tries, isAlone);
            Spares = NewSpares();
        }

        public SpareSlots Spares { get; }

        public int Posted { get; private set; }

        public int SlotsMade { get; private set; }

        public SpareSlots NewSpares() => _pool.NewSpares(SlotPoolTests.Spares, isOutside: false);

        public void Post(int number)
        {
            Posted++;
            Assert.Equal(number, Store(number, Spares));
        }

        public void PostMany(int count)
        {
            for (int i = 0; i < count; i++)
                Post(Posted + 1);
        }

        public int Store(int number, SpareSlots spares) => _pool.Store(new NumberCopier(number), spares, ref _latest);

        public int Load(ref NumberCopier value) => _pool.Load(ref value, ref _latest);

        public NumberSlot Pin() => _pool.Pin(ref _latest, out _);

        public void AssertLatest(int number)
        {
            var value = default(NumberCopier);
            Assert.Equal(number, Load(ref value));
            Assert.Equal(number, value.Number);
        }

        private NumberSlot NewSlot()
        {
            SlotsMade++;
            return new NumberSlot();
        }
    }

    private sealed class NumberSlot : Slot
    {
        public int Number;
    }

    /// <param name="number">The value.</param>
    /// <param name="inFrontOfACopy">What others do while this one copies the value of a slot.</param>
    private struct NumberCopier(int number, Action? inFrontOfACopy = null) : ISlotCopier<NumberSlot>
    {
        public int Number { get; private set; } = number;

        public readonly void CopyTo(NumberSlot slot) => slot.Number = Number;

        public void CopyFrom(NumberSlot slot)
        {
            inFrontOfACopy?.Invoke();
            Number = slot.Number;
        }
    }
}
