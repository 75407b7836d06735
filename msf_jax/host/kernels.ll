; 1bd0252a3b3bbc328e33665fa03f83b5118dcf46439ac40a2b1fd21ed756bfc3
; Made of the kernels by `python -m tests.translate`: edit those.

define internal fastcc void @_ZN7msf_jax4host5solid7kernels18triangle_distance2B2v2B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAEddd5ArrayIdLi3E1C7mutable7alignedEx(ptr noalias nonnull writeonly %retptr, double %arg.x, double %arg.y, double %arg.z, ptr readonly %arg.triangles.4, i64 %arg.triangles.5.0, i64 %arg.triangles.5.1, i64 %arg.triangles.5.2, i64 %arg.row) unnamed_addr {
B60.endif.endif:
  %.234 = icmp slt i64 %arg.row, 0
  %.235 = select i1 %.234, i64 %arg.triangles.5.0, i64 0
  %.236 = add i64 %.235, %arg.row
  %.264 = mul i64 %arg.triangles.5.2, %arg.triangles.5.1
  %.266 = mul i64 %.264, %.236
  %.272 = getelementptr double, ptr %arg.triangles.4, i64 %.266
  %.273 = load double, ptr %.272, align 8
  %.348 = getelementptr i8, ptr %.272, i64 8
  %.349 = load double, ptr %.348, align 8
  %.424 = getelementptr i8, ptr %.272, i64 16
  %.425 = load double, ptr %.424, align 8
  %0 = getelementptr double, ptr %arg.triangles.4, i64 %arg.triangles.5.2
  %.500 = getelementptr double, ptr %0, i64 %.266
  %.501 = load double, ptr %.500, align 8
  %.502 = fsub double %.501, %.273
  %.577 = getelementptr i8, ptr %.500, i64 8
  %.578 = load double, ptr %.577, align 8
  %.579 = fsub double %.578, %.349
  %.654 = getelementptr i8, ptr %.500, i64 16
  %.655 = load double, ptr %.654, align 8
  %.656 = fsub double %.655, %.425
  %.667 = fsub double %arg.x, %.273
  %.669 = fsub double %arg.y, %.349
  %.671 = fsub double %arg.z, %.425
  %.10.i = fmul double %.502, %.502
  %.11.i = fmul double %.656, %.656
  %.12.i = fadd double %.10.i, %.11.i
  %.13.i = fmul double %.579, %.579
  %.14.i = fadd double %.13.i, %.12.i
  %.717 = fcmp ogt double %.14.i, 0.000000e+00
  br i1 %.717, label %B310.endif.endif.endif, label %B60.endif.endif.1

common.ret:                                       ; preds = %B1158.endif, %B916.endif.endif.endif.endif, %B534.endif
  %best.4.0 = phi double [ %.11.i68, %B534.endif ], [ %.11.i68, %B916.endif.endif.endif.endif ], [ %.11.i80, %B1158.endif ]
  store double %best.4.0, ptr %retptr, align 8
  ret void

B310.endif.endif.endif:                           ; preds = %B60.endif.endif
  %.10.i1 = fmul double %.667, %.502
  %.11.i2 = fmul double %.671, %.656
  %.12.i3 = fadd double %.10.i1, %.11.i2
  %.13.i4 = fmul double %.669, %.579
  %.14.i5 = fadd double %.13.i4, %.12.i3
  %.754 = fdiv double %.14.i5, %.14.i
  %.10.i21 = fcmp olt double %.754, 0.000000e+00
  %.11.i22 = select i1 %.10.i21, double 0.000000e+00, double %.754
  %.10.i23 = fcmp ogt double %.11.i22, 1.000000e+00
  %.11.i24 = select i1 %.10.i23, double 1.000000e+00, double %.11.i22
  br label %B60.endif.endif.1

B60.endif.endif.1:                                ; preds = %B310.endif.endif.endif, %B60.endif.endif
  %"$phi414.1.2.1" = phi double [ 0.000000e+00, %B60.endif.endif ], [ %.11.i24, %B310.endif.endif.endif ]
  %.826 = fmul double %.502, %"$phi414.1.2.1"
  %.830 = fsub double %.667, %.826
  %.834 = fmul double %.579, %"$phi414.1.2.1"
  %.838 = fsub double %.669, %.834
  %.842 = fmul double %.656, %"$phi414.1.2.1"
  %.846 = fsub double %.671, %.842
  %.10.i6 = fmul double %.830, %.830
  %.11.i7 = fmul double %.846, %.846
  %.12.i8 = fadd double %.10.i6, %.11.i7
  %.13.i9 = fmul double %.838, %.838
  %.14.i10 = fadd double %.13.i9, %.12.i8
  %.10.i25 = fcmp olt double %.14.i10, 0x7FF0000000000000
  %.11.i26 = select i1 %.10.i25, double %.14.i10, double 0x7FF0000000000000
  %.idx = shl i64 %arg.triangles.5.2, 4
  %1 = getelementptr i8, ptr %arg.triangles.4, i64 %.idx
  %.500.1 = getelementptr double, ptr %1, i64 %.266
  %.501.1 = load double, ptr %.500.1, align 8
  %.502.1 = fsub double %.501.1, %.501
  %.577.1 = getelementptr i8, ptr %.500.1, i64 8
  %.578.1 = load double, ptr %.577.1, align 8
  %.579.1 = fsub double %.578.1, %.578
  %.654.1 = getelementptr i8, ptr %.500.1, i64 16
  %.655.1 = load double, ptr %.654.1, align 8
  %.656.1 = fsub double %.655.1, %.655
  %.667.1 = fsub double %arg.x, %.501
  %.669.1 = fsub double %arg.y, %.578
  %.671.1 = fsub double %arg.z, %.655
  %.10.i27 = fmul double %.502.1, %.502.1
  %.11.i28 = fmul double %.656.1, %.656.1
  %.12.i29 = fadd double %.10.i27, %.11.i28
  %.13.i30 = fmul double %.579.1, %.579.1
  %.14.i31 = fadd double %.13.i30, %.12.i29
  %.717.1 = fcmp ogt double %.14.i31, 0.000000e+00
  br i1 %.717.1, label %B310.endif.endif.endif.1, label %B60.endif.endif.2

B310.endif.endif.endif.1:                         ; preds = %B60.endif.endif.1
  %.10.i32 = fmul double %.667.1, %.502.1
  %.11.i33 = fmul double %.671.1, %.656.1
  %.12.i34 = fadd double %.10.i32, %.11.i33
  %.13.i35 = fmul double %.669.1, %.579.1
  %.14.i36 = fadd double %.13.i35, %.12.i34
  %.754.1 = fdiv double %.14.i36, %.14.i31
  %.10.i37 = fcmp olt double %.754.1, 0.000000e+00
  %.11.i38 = select i1 %.10.i37, double 0.000000e+00, double %.754.1
  %.10.i39 = fcmp ogt double %.11.i38, 1.000000e+00
  %.11.i40 = select i1 %.10.i39, double 1.000000e+00, double %.11.i38
  br label %B60.endif.endif.2

B60.endif.endif.2:                                ; preds = %B310.endif.endif.endif.1, %B60.endif.endif.1
  %"$phi414.1.2.1.1" = phi double [ 0.000000e+00, %B60.endif.endif.1 ], [ %.11.i40, %B310.endif.endif.endif.1 ]
  %.826.1 = fmul double %.502.1, %"$phi414.1.2.1.1"
  %.830.1 = fsub double %.667.1, %.826.1
  %.834.1 = fmul double %.579.1, %"$phi414.1.2.1.1"
  %.838.1 = fsub double %.669.1, %.834.1
  %.842.1 = fmul double %.656.1, %"$phi414.1.2.1.1"
  %.846.1 = fsub double %.671.1, %.842.1
  %.10.i41 = fmul double %.830.1, %.830.1
  %.11.i42 = fmul double %.846.1, %.846.1
  %.12.i43 = fadd double %.10.i41, %.11.i42
  %.13.i44 = fmul double %.838.1, %.838.1
  %.14.i45 = fadd double %.13.i44, %.12.i43
  %.10.i46 = fcmp olt double %.14.i45, %.11.i26
  %.11.i47 = select i1 %.10.i46, double %.14.i45, double %.11.i26
  %.502.2 = fsub double %.273, %.501.1
  %.579.2 = fsub double %.349, %.578.1
  %.656.2 = fsub double %.425, %.655.1
  %.667.2 = fsub double %arg.x, %.501.1
  %.669.2 = fsub double %arg.y, %.578.1
  %.671.2 = fsub double %arg.z, %.655.1
  %.10.i48 = fmul double %.502.2, %.502.2
  %.11.i49 = fmul double %.656.2, %.656.2
  %.12.i50 = fadd double %.10.i48, %.11.i49
  %.13.i51 = fmul double %.579.2, %.579.2
  %.14.i52 = fadd double %.13.i51, %.12.i50
  %.717.2 = fcmp ogt double %.14.i52, 0.000000e+00
  br i1 %.717.2, label %B310.endif.endif.endif.2, label %B534.endif

B310.endif.endif.endif.2:                         ; preds = %B60.endif.endif.2
  %.10.i53 = fmul double %.667.2, %.502.2
  %.11.i54 = fmul double %.671.2, %.656.2
  %.12.i55 = fadd double %.10.i53, %.11.i54
  %.13.i56 = fmul double %.669.2, %.579.2
  %.14.i57 = fadd double %.13.i56, %.12.i55
  %.754.2 = fdiv double %.14.i57, %.14.i52
  %.10.i58 = fcmp olt double %.754.2, 0.000000e+00
  %.11.i59 = select i1 %.10.i58, double 0.000000e+00, double %.754.2
  %.10.i60 = fcmp ogt double %.11.i59, 1.000000e+00
  %.11.i61 = select i1 %.10.i60, double 1.000000e+00, double %.11.i59
  br label %B534.endif

B534.endif:                                       ; preds = %B310.endif.endif.endif.2, %B60.endif.endif.2
  %"$phi414.1.2.1.2" = phi double [ 0.000000e+00, %B60.endif.endif.2 ], [ %.11.i61, %B310.endif.endif.endif.2 ]
  %.826.2 = fmul double %.502.2, %"$phi414.1.2.1.2"
  %.830.2 = fsub double %.667.2, %.826.2
  %.834.2 = fmul double %.579.2, %"$phi414.1.2.1.2"
  %.838.2 = fsub double %.669.2, %.834.2
  %.842.2 = fmul double %.656.2, %"$phi414.1.2.1.2"
  %.846.2 = fsub double %.671.2, %.842.2
  %.10.i62 = fmul double %.830.2, %.830.2
  %.11.i63 = fmul double %.846.2, %.846.2
  %.12.i64 = fadd double %.10.i62, %.11.i63
  %.13.i65 = fmul double %.838.2, %.838.2
  %.14.i66 = fadd double %.13.i65, %.12.i64
  %.10.i67 = fcmp olt double %.14.i66, %.11.i47
  %.11.i68 = select i1 %.10.i67, double %.14.i66, double %.11.i47
  %.1458 = fsub double %.501.1, %.273
  %.1535 = fsub double %.578.1, %.349
  %.1616 = fsub double %.655.1, %.425
  %.1649 = fmul double %.579, %.1616
  %.1652 = fmul double %.656, %.1535
  %.1653 = fsub double %.1649, %.1652
  %.1656 = fmul double %.656, %.1458
  %.1659 = fmul double %.502, %.1616
  %.1660 = fsub double %.1656, %.1659
  %.1663 = fmul double %.502, %.1535
  %.1666 = fmul double %.579, %.1458
  %.1667 = fsub double %.1663, %.1666
  %.10.i69 = fmul double %.1653, %.1653
  %.11.i70 = fmul double %.1667, %.1667
  %.12.i71 = fadd double %.11.i70, %.10.i69
  %.13.i72 = fmul double %.1660, %.1660
  %.14.i73 = fadd double %.13.i72, %.12.i71
  %.1713 = fcmp ogt double %.14.i73, 0.000000e+00
  br i1 %.1713, label %B916.endif.endif.endif.endif, label %common.ret

B916.endif.endif.endif.endif:                     ; preds = %B534.endif
  %.1721 = fmul double %.669, %.1616
  %.1724 = fmul double %.671, %.1535
  %.1725 = fsub double %.1721, %.1724
  %.1728 = fmul double %.671, %.1458
  %.1731 = fmul double %.667, %.1616
  %.1734 = fsub double %.1728, %.1731
  %.1737 = fmul double %.667, %.1535
  %.1742 = fmul double %.669, %.1458
  %.1745 = fsub double %.1737, %.1742
  %.10.i11 = fmul double %.1725, %.1653
  %.11.i12 = fmul double %.1745, %.1667
  %.12.i13 = fadd double %.11.i12, %.10.i11
  %.13.i14 = fmul double %.1734, %.1660
  %.14.i15 = fadd double %.13.i14, %.12.i13
  %.1784 = fmul double %.671, %.579
  %.1787 = fmul double %.669, %.656
  %.1788 = fsub double %.1784, %.1787
  %.1791 = fmul double %.667, %.656
  %.1796 = fmul double %.671, %.502
  %.1797 = fsub double %.1791, %.1796
  %.1800 = fmul double %.669, %.502
  %.1805 = fmul double %.667, %.579
  %.1808 = fsub double %.1800, %.1805
  %.10.i74 = fmul double %.1788, %.1653
  %.11.i75 = fmul double %.1808, %.1667
  %.12.i76 = fadd double %.11.i75, %.10.i74
  %.13.i77 = fmul double %.1797, %.1660
  %.14.i78 = fadd double %.13.i77, %.12.i76
  %.1777 = fdiv double %.14.i15, %.14.i73
  %.1840 = fdiv double %.14.i78, %.14.i73
  %.1846 = fcmp oge double %.1777, 0.000000e+00
  %.1853 = fcmp oge double %.1840, 0.000000e+00
  %.1860 = fadd double %.1777, %.1840
  %.1866 = fcmp ole double %.1860, 1.000000e+00
  %2 = and i1 %.1853, %.1866
  %or.cond451 = select i1 %.1846, i1 %2, i1 false
  br i1 %or.cond451, label %B1158.endif, label %common.ret

B1158.endif:                                      ; preds = %B916.endif.endif.endif.endif
  %.10.i16 = fmul double %.667, %.1653
  %.11.i17 = fmul double %.671, %.1667
  %.12.i18 = fadd double %.11.i17, %.10.i16
  %.13.i19 = fmul double %.669, %.1660
  %.14.i20 = fadd double %.13.i19, %.12.i18
  %.1911 = fmul double %.14.i20, %.14.i20
  %.1916 = fdiv double %.1911, %.14.i73
  %.10.i79 = fcmp olt double %.1916, %.11.i68
  %.11.i80 = select i1 %.10.i79, double %.1916, double %.11.i68
  br label %common.ret
}

define noundef i64 @msf_jax.host.solid.kernels.distances2(ptr readonly %words) local_unnamed_addr {
  %.345.i = alloca double, align 8
  %w0 = load ptr, ptr %words, align 8
  %p1 = getelementptr i8, ptr %words, i64 8
  %w1 = load i64, ptr %p1, align 8
  %p2 = getelementptr i8, ptr %words, i64 16
  %w2 = load i64, ptr %p2, align 8
  %s3 = shl i64 %w2, 3
  %p3 = getelementptr i8, ptr %words, i64 24
  %w3 = load ptr, ptr %p3, align 8
  %p4 = getelementptr i8, ptr %words, i64 32
  %w4 = load i64, ptr %p4, align 8
  %p5 = getelementptr i8, ptr %words, i64 40
  %w5 = load i64, ptr %p5, align 8
  %p6 = getelementptr i8, ptr %words, i64 48
  %w6 = load i64, ptr %p6, align 8
  %p7 = getelementptr i8, ptr %words, i64 56
  %w7 = load ptr, ptr %p7, align 8
  call void @llvm.lifetime.start.p0(ptr nonnull %.345.i)
  %.143161.not.i = icmp slt i64 %w1, 1
  br i1 %.143161.not.i, label %_ZN7msf_jax4host5solid7kernels10distances2B2v1B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B62.preheader.i

B62.preheader.i:                                  ; preds = %0
  %scevgep.i = getelementptr i8, ptr %w0, i64 16
  br label %B62.i

B62.i:                                            ; preds = %B62.i, %B62.preheader.i
  %lsr.iv.i = phi ptr [ %scevgep.i, %B62.preheader.i ], [ %scevgep5.i, %B62.i ]
  %.149160162.i = phi i64 [ 0, %B62.preheader.i ], [ %.156.i, %B62.i ]
  %scevgep7.i = getelementptr i8, ptr %lsr.iv.i, i64 -16
  %.235.i = load double, ptr %scevgep7.i, align 8
  %scevgep6.i = getelementptr i8, ptr %lsr.iv.i, i64 -8
  %.289.i = load double, ptr %scevgep6.i, align 8
  %.343.i = load double, ptr %lsr.iv.i, align 8
  call fastcc void @_ZN7msf_jax4host5solid7kernels18triangle_distance2B2v2B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAEddd5ArrayIdLi3E1C7mutable7alignedEx(ptr nonnull %.345.i, double %.235.i, double %.289.i, double %.343.i, ptr readonly %w3, i64 %w4, i64 %w5, i64 %w6, i64 %.149160162.i)
  %.156.i = add nuw nsw i64 %.149160162.i, 1
  %.365.i = load double, ptr %.345.i, align 8
  %1 = shl i64 %.149160162.i, 3
  %scevgep8.i = getelementptr i8, ptr %w7, i64 %1
  store double %.365.i, ptr %scevgep8.i, align 8
  %scevgep5.i = getelementptr i8, ptr %lsr.iv.i, i64 %s3
  %exitcond.not.i = icmp eq i64 %w1, %.156.i
  br i1 %exitcond.not.i, label %_ZN7msf_jax4host5solid7kernels10distances2B2v1B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B62.i

_ZN7msf_jax4host5solid7kernels10distances2B2v1B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B62.i, %0
  call void @llvm.lifetime.end.p0(ptr nonnull %.345.i)
  ret i64 0
}

define noundef i64 @msf_jax.host.solid.kernels.nearest(ptr readonly %words) local_unnamed_addr {
  %.978.i = alloca double, align 8
  %w0 = load ptr, ptr %words, align 8
  %p1 = getelementptr i8, ptr %words, i64 8
  %w1 = load i64, ptr %p1, align 8
  %p2 = getelementptr i8, ptr %words, i64 16
  %w2 = load i64, ptr %p2, align 8
  %p8 = getelementptr i8, ptr %words, i64 64
  %w8 = load ptr, ptr %p8, align 8
  %p9 = getelementptr i8, ptr %words, i64 72
  %w9 = load i64, ptr %p9, align 8
  %p10 = getelementptr i8, ptr %words, i64 80
  %w10 = load i64, ptr %p10, align 8
  %p11 = getelementptr i8, ptr %words, i64 88
  %w11 = load i64, ptr %p11, align 8
  %p14 = getelementptr i8, ptr %words, i64 112
  %w14 = load ptr, ptr %p14, align 8
  %p15 = getelementptr i8, ptr %words, i64 120
  %w15 = load i64, ptr %p15, align 8
  %p16 = getelementptr i8, ptr %words, i64 128
  %w16 = load i64, ptr %p16, align 8
  %p17 = getelementptr i8, ptr %words, i64 136
  %w17 = load ptr, ptr %p17, align 8
  %p18 = getelementptr i8, ptr %words, i64 144
  %w18 = load i64, ptr %p18, align 8
  %p19 = getelementptr i8, ptr %words, i64 152
  %w19 = load ptr, ptr %p19, align 8
  %p21 = getelementptr i8, ptr %words, i64 168
  %w21 = load ptr, ptr %p21, align 8
  %p22 = getelementptr i8, ptr %words, i64 176
  %w22 = load i64, ptr %p22, align 8
  %p23 = getelementptr i8, ptr %words, i64 184
  %w23 = load ptr, ptr %p23, align 8
  %p24 = getelementptr i8, ptr %words, i64 192
  %w24 = load i64, ptr %p24, align 8
  %p25 = getelementptr i8, ptr %words, i64 200
  %w25 = load i8, ptr %p25, align 8
  %p26 = getelementptr i8, ptr %words, i64 208
  %w26 = load ptr, ptr %p26, align 8
  %p28 = getelementptr i8, ptr %words, i64 224
  %w28 = load ptr, ptr %p28, align 8
  call void @llvm.lifetime.start.p0(ptr nonnull %.978.i)
  %.272638.not.i = icmp slt i64 %w1, 1
  br i1 %.272638.not.i, label %_ZN7msf_jax4host5solid7kernels7nearestB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEb5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B118.preheader.i

B118.preheader.i:                                 ; preds = %0
  %1 = icmp eq i8 %w25, 0
  br label %B118.i

B118.i:                                           ; preds = %B640.i, %B118.preheader.i
  %.278635639.i = phi i64 [ %.285.i, %B640.i ], [ 0, %B118.preheader.i ]
  %.285.i = add nuw nsw i64 %.278635639.i, 1
  %.362.i = mul i64 %.278635639.i, %w2
  %.366.i = getelementptr double, ptr %w0, i64 %.362.i
  %.367.i = load double, ptr %.366.i, align 8
  %.421.i = getelementptr i8, ptr %.366.i, i64 8
  %.422.i = load double, ptr %.421.i, align 8
  %.476.i = getelementptr i8, ptr %.366.i, i64 16
  %.477.i = load double, ptr %.476.i, align 8
  %2 = getelementptr i64, ptr %w19, i64 %.278635639.i
  %.524.i = load i64, ptr %2, align 8
  %.538.i = icmp slt i64 %.524.i, 0
  %.539.i = select i1 %.538.i, i64 %w22, i64 0
  %3 = getelementptr i64, ptr %w21, i64 %.524.i
  %.553.i = getelementptr i64, ptr %3, i64 %.539.i
  %.554.i = load i64, ptr %.553.i, align 8
  br i1 %1, label %B252.i, label %B294.preheader.i

B252.i:                                           ; preds = %B118.i
  %.669.i = icmp slt i64 %.524.i, -1
  %.670.i = select i1 %.669.i, i64 %w22, i64 0
  %4 = getelementptr i8, ptr %3, i64 8
  %.684.i = getelementptr i64, ptr %4, i64 %.670.i
  %.685.i = load i64, ptr %.684.i, align 8
  %.687.i = icmp slt i64 %.554.i, %.685.i
  br i1 %.687.i, label %B294.preheader.i, label %B640.i

B294.preheader.i:                                 ; preds = %B118.i, %B252.i
  %node.2.1.ph.i = phi i64 [ 0, %B252.i ], [ 1, %B118.i ]
  %.748.i = icmp slt i64 %.524.i, -1
  %.749.i = select i1 %.748.i, i64 %w22, i64 0
  %5 = getelementptr i8, ptr %3, i64 8
  %.763.i = getelementptr i64, ptr %5, i64 %.749.i
  %.764.i = load i64, ptr %.763.i, align 8
  br label %B294.i

B294.i:                                           ; preds = %B594.i, %B294.preheader.i
  %which.2.1.i = phi i64 [ %w18, %B294.preheader.i ], [ %which.3.3.i, %B594.i ]
  %best.2.1.i = phi double [ 0x7FF0000000000000, %B294.preheader.i ], [ %best.3.3.i, %B594.i ]
  %node.2.1.i = phi i64 [ %node.2.1.ph.i, %B294.preheader.i ], [ %node.3.315.i, %B594.i ]
  %place.2.1.i = phi i64 [ %.554.i, %B294.preheader.i ], [ %place.3.316.i, %B594.i ]
  %.766.i = icmp slt i64 %place.2.1.i, %.764.i
  br i1 %.766.i, label %B336.i, label %B364.i

B336.i:                                           ; preds = %B294.i
  %.788.i = icmp slt i64 %place.2.1.i, 0
  %.789.i = select i1 %.788.i, i64 %w24, i64 0
  %6 = getelementptr i64, ptr %w23, i64 %place.2.1.i
  %.803.i = getelementptr i64, ptr %6, i64 %.789.i
  %.804.i = load i64, ptr %.803.i, align 8
  %.809.i = add nsw i64 %place.2.1.i, 1
  br label %B500.i

B364.i:                                           ; preds = %B294.i
  %.47.i.i = icmp slt i64 %node.2.1.i, 0
  %.48.i.i = select i1 %.47.i.i, i64 %w15, i64 0
  %.49.i.i = add i64 %.48.i.i, %node.2.1.i
  %.69.i.i = mul i64 %.49.i.i, %w16
  %.73.i.i = getelementptr double, ptr %w14, i64 %.69.i.i
  %.74.i.i = load double, ptr %.73.i.i, align 8
  %.75.i.i = fsub double %.74.i.i, %.367.i
  %.127.i.i = getelementptr i8, ptr %.73.i.i, i64 24
  %.128.i.i = load double, ptr %.127.i.i, align 8
  %.129.i.i = fsub double %.367.i, %.128.i.i
  %.13.i.i.i = fcmp ogt double %.129.i.i, %.75.i.i
  %.14.i.i.i = select i1 %.13.i.i.i, double %.129.i.i, double %.75.i.i
  %.15.i.i.i = fcmp olt double %.14.i.i.i, 0.000000e+00
  %.16.i.i.i = select i1 %.15.i.i.i, double 0.000000e+00, double %.14.i.i.i
  %.213.i.i = getelementptr i8, ptr %.73.i.i, i64 8
  %.214.i.i = load double, ptr %.213.i.i, align 8
  %.215.i.i = fsub double %.214.i.i, %.422.i
  %.267.i.i = getelementptr i8, ptr %.73.i.i, i64 32
  %.268.i.i = load double, ptr %.267.i.i, align 8
  %.269.i.i = fsub double %.422.i, %.268.i.i
  %.13.i1.i.i = fcmp ogt double %.269.i.i, %.215.i.i
  %.14.i2.i.i = select i1 %.13.i1.i.i, double %.269.i.i, double %.215.i.i
  %.15.i3.i.i = fcmp olt double %.14.i2.i.i, 0.000000e+00
  %.16.i4.i.i = select i1 %.15.i3.i.i, double 0.000000e+00, double %.14.i2.i.i
  %.351.i.i = getelementptr i8, ptr %.73.i.i, i64 16
  %.352.i.i = load double, ptr %.351.i.i, align 8
  %.353.i.i = fsub double %.352.i.i, %.477.i
  %.405.i.i = getelementptr i8, ptr %.73.i.i, i64 40
  %.406.i.i = load double, ptr %.405.i.i, align 8
  %.407.i.i = fsub double %.477.i, %.406.i.i
  %.13.i5.i.i = fcmp ogt double %.407.i.i, %.353.i.i
  %.14.i6.i.i = select i1 %.13.i5.i.i, double %.407.i.i, double %.353.i.i
  %.15.i7.i.i = fcmp olt double %.14.i6.i.i, 0.000000e+00
  %.16.i8.i.i = select i1 %.15.i7.i.i, double 0.000000e+00, double %.14.i6.i.i
  %.438.i.i = fmul double %.16.i.i.i, %.16.i.i.i
  %.439.i.i = fmul double %.16.i4.i.i, %.16.i4.i.i
  %.440.i.i = fadd double %.438.i.i, %.439.i.i
  %.441.i.i = fmul double %.16.i8.i.i, %.16.i8.i.i
  %.442.i.i = fadd double %.440.i.i, %.441.i.i
  %.443.i.i = fmul double %best.2.1.i, 0x3FF0000000001198
  %.444.i.i = fcmp ugt double %.442.i.i, %.443.i.i
  br i1 %.444.i.i, label %B30.i.i, label %B418.i

B418.i:                                           ; preds = %B364.i
  %.868.not.i = icmp slt i64 %node.2.1.i, %w18
  br i1 %.868.not.i, label %B500.thread.i, label %B464.i

B464.i:                                           ; preds = %B418.i
  %.874.i = sub nsw i64 %node.2.1.i, %w18
  %.902.i = getelementptr i64, ptr %w17, i64 %.874.i
  %.903.i = load i64, ptr %.902.i, align 8
  br label %B30.i.i

B500.thread.i:                                    ; preds = %B418.i
  %.28.i.i = shl nsw i64 %node.2.1.i, 1
  br label %B594.i

B30.i.i:                                          ; preds = %B464.i, %B364.i
  %"$phi464.1.2.48.i" = phi i64 [ %.903.i, %B464.i ], [ -1, %B364.i ]
  %.36.i.i = add nsw i64 %node.2.1.i, 1
  %7 = and i64 %node.2.1.i, 1
  %.46.not.not.i.i = icmp eq i64 %7, 0
  br i1 %.46.not.not.i.i, label %B70.i.i, label %B50.i.i

B50.i.i:                                          ; preds = %B30.i.i, %B50.i.i
  %node.3.1.i.i = phi i64 [ %.49.i3.i, %B50.i.i ], [ %.36.i.i, %B30.i.i ]
  %.49.i3.i = ashr i64 %node.3.1.i.i, 1
  %8 = and i64 %node.3.1.i.i, 2
  %.55.not.i.i = icmp eq i64 %8, 0
  br i1 %.55.not.i.i, label %B50.i.i, label %B70.i.i

B70.i.i:                                          ; preds = %B50.i.i, %B30.i.i
  %node.4.0.i.i = phi i64 [ %.36.i.i, %B30.i.i ], [ %.49.i3.i, %B50.i.i ]
  %.60.i.i = icmp sgt i64 %node.4.0.i.i, 1
  %spec.select.i.i = select i1 %.60.i.i, i64 %node.4.0.i.i, i64 0
  br label %B500.i

B500.i:                                           ; preds = %B70.i.i, %B336.i
  %node.3.3.i = phi i64 [ %node.2.1.i, %B336.i ], [ %spec.select.i.i, %B70.i.i ]
  %triangle.2.3.i = phi i64 [ %.804.i, %B336.i ], [ %"$phi464.1.2.48.i", %B70.i.i ]
  %place.3.3.i = phi i64 [ %.809.i, %B336.i ], [ %place.2.1.i, %B70.i.i ]
  %.966.i = icmp sgt i64 %triangle.2.3.i, -1
  br i1 %.966.i, label %B512.i, label %B594.i

B512.i:                                           ; preds = %B500.i
  call fastcc void @_ZN7msf_jax4host5solid7kernels18triangle_distance2B2v2B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAEddd5ArrayIdLi3E1C7mutable7alignedEx(ptr nonnull %.978.i, double %.367.i, double %.422.i, double %.477.i, ptr readonly %w8, i64 %w9, i64 %w10, i64 %w11, i64 %triangle.2.3.i)
  %.998.i = load double, ptr %.978.i, align 8
  %.1013.i = fcmp olt double %.998.i, %best.2.1.i
  br i1 %.1013.i, label %B586.i, label %B562.i

B562.i:                                           ; preds = %B512.i
  %.1023.i = fcmp oeq double %.998.i, %best.2.1.i
  %.1035.i = icmp slt i64 %triangle.2.3.i, %which.2.1.i
  %or.cond.i = select i1 %.1023.i, i1 %.1035.i, i1 false
  br i1 %or.cond.i, label %B586.i, label %B594.i

B586.i:                                           ; preds = %B562.i, %B512.i
  br label %B594.i

B594.i:                                           ; preds = %B586.i, %B562.i, %B500.i, %B500.thread.i
  %place.3.316.i = phi i64 [ %place.3.3.i, %B586.i ], [ %place.3.3.i, %B500.i ], [ %place.3.3.i, %B562.i ], [ %place.2.1.i, %B500.thread.i ]
  %node.3.315.i = phi i64 [ %node.3.3.i, %B586.i ], [ %node.3.3.i, %B500.i ], [ %node.3.3.i, %B562.i ], [ %.28.i.i, %B500.thread.i ]
  %which.3.3.i = phi i64 [ %triangle.2.3.i, %B586.i ], [ %which.2.1.i, %B500.i ], [ %which.2.1.i, %B562.i ], [ %which.2.1.i, %B500.thread.i ]
  %best.3.3.i = phi double [ %.998.i, %B586.i ], [ %best.2.1.i, %B500.i ], [ %best.2.1.i, %B562.i ], [ %best.2.1.i, %B500.thread.i ]
  %.1063.not.i = icmp ne i64 %node.3.315.i, 0
  %.1134.i = icmp slt i64 %place.3.316.i, %.764.i
  %or.cond17.i = select i1 %.1063.not.i, i1 true, i1 %.1134.i
  br i1 %or.cond17.i, label %B294.i, label %B640.i

B640.i:                                           ; preds = %B594.i, %B252.i
  %which.4.2.i = phi i64 [ %w18, %B252.i ], [ %which.3.3.i, %B594.i ]
  %best.4.2.i = phi double [ 0x7FF0000000000000, %B252.i ], [ %best.3.3.i, %B594.i ]
  %9 = getelementptr double, ptr %w26, i64 %.278635639.i
  store double %best.4.2.i, ptr %9, align 8
  %10 = getelementptr i64, ptr %w28, i64 %.278635639.i
  store i64 %which.4.2.i, ptr %10, align 8
  %exitcond.not.i = icmp eq i64 %w1, %.285.i
  br i1 %exitcond.not.i, label %_ZN7msf_jax4host5solid7kernels7nearestB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEb5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B118.i

_ZN7msf_jax4host5solid7kernels7nearestB2v6B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEb5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B640.i, %0
  call void @llvm.lifetime.end.p0(ptr nonnull %.978.i)
  ret i64 0
}

define noundef i64 @msf_jax.host.solid.kernels.windings(ptr readonly %words) local_unnamed_addr {
  %w0 = load ptr, ptr %words, align 8
  %p1 = getelementptr i8, ptr %words, i64 8
  %w1 = load i64, ptr %p1, align 8
  %p2 = getelementptr i8, ptr %words, i64 16
  %w2 = load i64, ptr %p2, align 8
  %p6 = getelementptr i8, ptr %words, i64 48
  %w6 = load ptr, ptr %p6, align 8
  %p7 = getelementptr i8, ptr %words, i64 56
  %w7 = load i64, ptr %p7, align 8
  %p8 = getelementptr i8, ptr %words, i64 64
  %w8 = load ptr, ptr %p8, align 8
  %p9 = getelementptr i8, ptr %words, i64 72
  %w9 = load i64, ptr %p9, align 8
  %p11 = getelementptr i8, ptr %words, i64 88
  %w11 = load i64, ptr %p11, align 8
  %p14 = getelementptr i8, ptr %words, i64 112
  %w14 = load ptr, ptr %p14, align 8
  %p15 = getelementptr i8, ptr %words, i64 120
  %w15 = load i64, ptr %p15, align 8
  %p16 = getelementptr i8, ptr %words, i64 128
  %w16 = load i64, ptr %p16, align 8
  %p17 = getelementptr i8, ptr %words, i64 136
  %w17 = load ptr, ptr %p17, align 8
  %p18 = getelementptr i8, ptr %words, i64 144
  %w18 = load i64, ptr %p18, align 8
  %p19 = getelementptr i8, ptr %words, i64 152
  %w19 = load ptr, ptr %p19, align 8
  %.234836.not.i = icmp slt i64 %w1, 1
  br i1 %.234836.not.i, label %_ZN7msf_jax4host5solid7kernels8windingsB3v10B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE.exit, label %B152.lr.ph.i

B152.lr.ph.i:                                     ; preds = %0
  %p10 = getelementptr i8, ptr %words, i64 80
  %w10 = load i64, ptr %p10, align 8
  %.962.i = mul i64 %w10, %w11
  %.idx.i = shl i64 %w11, 4
  br label %B152.i

B152.i:                                           ; preds = %B1008.i, %B152.lr.ph.i
  %.240822839.i = phi i64 [ 0, %B152.lr.ph.i ], [ %.247.i, %B1008.i ]
  %.324.i = mul i64 %.240822839.i, %w2
  %.328.i = getelementptr double, ptr %w0, i64 %.324.i
  %.329.i = load double, ptr %.328.i, align 8
  %.383.i = getelementptr i8, ptr %.328.i, i64 8
  %.384.i = load double, ptr %.383.i, align 8
  %.438.i = getelementptr i8, ptr %.328.i, i64 16
  %.439.i = load double, ptr %.438.i, align 8
  br label %B230.outer.i

B230.outer.i:                                     ; preds = %B70.i.i, %B152.i
  %winding.2.1.ph.i = phi i64 [ %winding.3.324.i, %B70.i.i ], [ 0, %B152.i ]
  %node.2.1.ph.i = phi i64 [ %node.4.0.i.i, %B70.i.i ], [ 1, %B152.i ]
  %.87.i3.i = mul i64 %node.2.1.ph.i, %w16
  %.91.i4.i = getelementptr double, ptr %w14, i64 %.87.i3.i
  %.92.i5.i = load double, ptr %.91.i4.i, align 8
  %.93.i6.i = fcmp ogt double %.92.i5.i, %.329.i
  br i1 %.93.i6.i, label %B30.i.i, label %B32.i.i

B32.i.i:                                          ; preds = %B230.outer.i, %B20.i.i
  %.87.i8.i = phi i64 [ %.87.i.i, %B20.i.i ], [ %.87.i3.i, %B230.outer.i ]
  %node.2.17.i = phi i64 [ %.28.i.i, %B20.i.i ], [ %node.2.1.ph.i, %B230.outer.i ]
  %sunkaddr.i.i = shl i64 %.87.i8.i, 3
  %sunkaddr1.i.i = getelementptr i8, ptr %w14, i64 %sunkaddr.i.i
  %sunkaddr2.i.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 8
  %.152.i.i = load double, ptr %sunkaddr2.i.i, align 8
  %.154.i.i = fcmp ogt double %.152.i.i, %.384.i
  br i1 %.154.i.i, label %B30.i.i, label %B86.i.i

B86.i.i:                                          ; preds = %B32.i.i
  %sunkaddr37.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 24
  %.287.i.i = load double, ptr %sunkaddr37.i, align 8
  %.289.i.i = fcmp olt double %.287.i.i, %.329.i
  br i1 %.289.i.i, label %B30.i.i, label %B120.i.i

B120.i.i:                                         ; preds = %B86.i.i
  %sunkaddr40.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 32
  %.349.i.i = load double, ptr %sunkaddr40.i, align 8
  %.351.i.i = fcmp olt double %.349.i.i, %.384.i
  br i1 %.351.i.i, label %B30.i.i, label %_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i

_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i: ; preds = %B120.i.i
  %sunkaddr43.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 40
  %.413.i.i = load double, ptr %sunkaddr43.i, align 8
  %.417.i.i = fcmp uge double %.413.i.i, %.439.i
  br i1 %.417.i.i, label %B300.i, label %B30.i.i

B300.i:                                           ; preds = %_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i
  %.528.not.i = icmp slt i64 %node.2.17.i, %w18
  br i1 %.528.not.i, label %B20.i.i, label %B314.endif.endif.i

B684.i:                                           ; preds = %B314.endif.endif.i
  %.1381.i = fcmp oeq double %.1368.i, 0.000000e+00
  br i1 %.1381.i, label %B696.i, label %B730.i

B696.i:                                           ; preds = %B684.i
  %.1387.i = fcmp olt double %.1204.i, 0.000000e+00
  br i1 %.1387.i, label %B730.i, label %B708.i

B708.i:                                           ; preds = %B696.i
  %.1393.i = fcmp oeq double %.1204.i, 0.000000e+00
  br i1 %.1393.i, label %B720.i, label %B730.i

B720.i:                                           ; preds = %B708.i
  %.1401.i = fcmp ogt double %.1048.i, 0.000000e+00
  br label %B730.i

B730.i:                                           ; preds = %B314.endif.endif.i, %B720.i, %B708.i, %B696.i, %B684.i
  %"$phi730.2.5.5.i" = phi i1 [ true, %B314.endif.endif.i ], [ true, %B696.i ], [ %.1401.i, %B720.i ], [ false, %B708.i ], [ false, %B684.i ]
  %1 = xor i1 %.862.i, %"$phi730.2.5.5.i"
  %.1415.i = xor i1 %1, true
  %.1418.i = zext i1 %.1415.i to i64
  %.1437.i = fneg double %.1368.i
  %"$phi762.2.2.5.i" = select i1 %.862.i, double %.1368.i, double %.1437.i
  %.1452.i = fadd double %"$phi762.2.2.5.i", 0.000000e+00
  %sunkaddr44.i = shl i64 %.964.i, 3
  %sunkaddr45.i = getelementptr i8, ptr %w8, i64 %sunkaddr44.i
  %sunkaddr46.i = getelementptr i8, ptr %sunkaddr45.i, i64 16
  %.1533.i = load double, ptr %sunkaddr46.i, align 8
  %.1534.i = fmul double %"$phi762.2.2.5.i", %.1533.i
  %.1536.i = fadd double %.1534.i, 0.000000e+00
  %.860.1.i = getelementptr i64, ptr %13, i64 %.812.i
  %.861.1.i = load i64, ptr %.860.1.i, align 8
  %.862.1.i = icmp slt i64 %.861.i, %.861.1.i
  %"$phi502.2.2.sroa.8.5.1.i" = select i1 %.862.1.i, i64 0, i64 2
  %"$phi502.2.2.sroa.0.5.1.i" = select i1 %.862.1.i, i64 2, i64 0
  %.966.1.i = mul i64 %"$phi502.2.2.sroa.8.5.1.i", %w11
  %2 = getelementptr double, ptr %w8, i64 %.966.1.i
  %.970.1.i = getelementptr double, ptr %2, i64 %.964.i
  %.971.1.i = load double, ptr %.970.1.i, align 8
  %.1042.1.i = mul i64 %"$phi502.2.2.sroa.0.5.1.i", %w11
  %3 = getelementptr double, ptr %w8, i64 %.1042.1.i
  %.1046.1.i = getelementptr double, ptr %3, i64 %.964.i
  %.1047.1.i = load double, ptr %.1046.1.i, align 8
  %.1048.1.i = fsub double %.971.1.i, %.1047.1.i
  %.1126.1.i = getelementptr i8, ptr %.970.1.i, i64 8
  %.1127.1.i = load double, ptr %.1126.1.i, align 8
  %.1202.1.i = getelementptr i8, ptr %.1046.1.i, i64 8
  %.1203.1.i = load double, ptr %.1202.1.i, align 8
  %.1204.1.i = fsub double %.1127.1.i, %.1203.1.i
  %.1285.1.i = fsub double %.384.i, %.1203.1.i
  %.1287.1.i = fmul double %.1048.1.i, %.1285.1.i
  %.1365.1.i = fsub double %.329.i, %.1047.1.i
  %.1367.1.i = fmul double %.1365.1.i, %.1204.1.i
  %.1368.1.i = fsub double %.1287.1.i, %.1367.1.i
  %.1374.1.i = fcmp ogt double %.1368.1.i, 0.000000e+00
  br i1 %.1374.1.i, label %B730.1.i, label %B684.1.i

B684.1.i:                                         ; preds = %B730.i
  %.1381.1.i = fcmp oeq double %.1368.1.i, 0.000000e+00
  br i1 %.1381.1.i, label %B696.1.i, label %B730.1.i

B696.1.i:                                         ; preds = %B684.1.i
  %.1387.1.i = fcmp olt double %.1204.1.i, 0.000000e+00
  br i1 %.1387.1.i, label %B730.1.i, label %B708.1.i

B708.1.i:                                         ; preds = %B696.1.i
  %.1393.1.i = fcmp oeq double %.1204.1.i, 0.000000e+00
  br i1 %.1393.1.i, label %B720.1.i, label %B730.1.i

B720.1.i:                                         ; preds = %B708.1.i
  %.1401.1.i = fcmp ogt double %.1048.1.i, 0.000000e+00
  br label %B730.1.i

B730.1.i:                                         ; preds = %B720.1.i, %B708.1.i, %B696.1.i, %B684.1.i, %B730.i
  %"$phi730.2.5.5.1.i" = phi i1 [ true, %B730.i ], [ true, %B696.1.i ], [ %.1401.1.i, %B720.1.i ], [ false, %B708.1.i ], [ false, %B684.1.i ]
  %4 = xor i1 %.862.1.i, %"$phi730.2.5.5.1.i"
  %.1415.1.i = xor i1 %4, true
  %.1418.1.i = zext i1 %.1415.1.i to i64
  %.1419.1.i = add nuw nsw i64 %.1418.1.i, %.1418.i
  %.1437.1.i = fneg double %.1368.1.i
  %"$phi762.2.2.5.1.i" = select i1 %.862.1.i, double %.1368.1.i, double %.1437.1.i
  %.1452.1.i = fadd double %.1452.i, %"$phi762.2.2.5.1.i"
  %5 = getelementptr double, ptr %12, i64 %w11
  %.1532.1.i = getelementptr i8, ptr %5, i64 16
  %.1533.1.i = load double, ptr %.1532.1.i, align 8
  %.1534.1.i = fmul double %"$phi762.2.2.5.1.i", %.1533.1.i
  %.1536.1.i = fadd double %.1536.i, %.1534.1.i
  %.862.2.i = icmp slt i64 %.861.1.i, %.827.i
  %.966.2.i = select i1 %.862.2.i, i64 %w11, i64 0
  %6 = getelementptr double, ptr %w8, i64 %.966.2.i
  %.970.2.i = getelementptr double, ptr %6, i64 %.964.i
  %.971.2.i = load double, ptr %.970.2.i, align 8
  %.1042.2.i = select i1 %.862.2.i, i64 0, i64 %w11
  %7 = getelementptr double, ptr %w8, i64 %.1042.2.i
  %.1046.2.i = getelementptr double, ptr %7, i64 %.964.i
  %.1047.2.i = load double, ptr %.1046.2.i, align 8
  %.1048.2.i = fsub double %.971.2.i, %.1047.2.i
  %.1126.2.i = getelementptr i8, ptr %.970.2.i, i64 8
  %.1127.2.i = load double, ptr %.1126.2.i, align 8
  %.1202.2.i = getelementptr i8, ptr %.1046.2.i, i64 8
  %.1203.2.i = load double, ptr %.1202.2.i, align 8
  %.1204.2.i = fsub double %.1127.2.i, %.1203.2.i
  %.1285.2.i = fsub double %.384.i, %.1203.2.i
  %.1287.2.i = fmul double %.1048.2.i, %.1285.2.i
  %.1365.2.i = fsub double %.329.i, %.1047.2.i
  %.1367.2.i = fmul double %.1365.2.i, %.1204.2.i
  %.1368.2.i = fsub double %.1287.2.i, %.1367.2.i
  %.1374.2.i = fcmp ogt double %.1368.2.i, 0.000000e+00
  br i1 %.1374.2.i, label %B834.endif.endif.i, label %B684.2.i

B684.2.i:                                         ; preds = %B730.1.i
  %.1381.2.i = fcmp oeq double %.1368.2.i, 0.000000e+00
  br i1 %.1381.2.i, label %B696.2.i, label %B834.endif.endif.i

B696.2.i:                                         ; preds = %B684.2.i
  %.1387.2.i = fcmp olt double %.1204.2.i, 0.000000e+00
  br i1 %.1387.2.i, label %B834.endif.endif.i, label %B708.2.i

B708.2.i:                                         ; preds = %B696.2.i
  %.1393.2.i = fcmp oeq double %.1204.2.i, 0.000000e+00
  br i1 %.1393.2.i, label %B720.2.i, label %B834.endif.endif.i

B720.2.i:                                         ; preds = %B708.2.i
  %.1401.2.i = fcmp ogt double %.1048.2.i, 0.000000e+00
  br label %B834.endif.endif.i

B936.i:                                           ; preds = %B834.endif.endif.i
  %8 = xor i1 %.862.2.i, %"$phi730.2.5.5.2.i"
  %.1415.2.i = xor i1 %8, true
  %.1418.2.i = zext i1 %.1415.2.i to i64
  %.1419.2.i = add nuw nsw i64 %.1419.1.i, %.1418.2.i
  %.1748.i = icmp eq i64 %.1419.2.i, 3
  %.1750.i = icmp eq i64 %.1419.2.i, 0
  %.1754.i = zext i1 %.1748.i to i64
  %.1756.neg.i = sext i1 %.1750.i to i64
  %.1757.i = add i64 %winding.2.1.ph.i, %.1754.i
  %.1759.i = add i64 %.1757.i, %.1756.neg.i
  br label %B30.i.i

B20.i.i:                                          ; preds = %B300.i
  %.28.i.i = shl nsw i64 %node.2.17.i, 1
  %.65.i.i = icmp slt i64 %node.2.17.i, 0
  %.66.i.i = select i1 %.65.i.i, i64 %w15, i64 0
  %.67.i.i = add i64 %.66.i.i, %.28.i.i
  %.87.i.i = mul i64 %.67.i.i, %w16
  %.91.i.i = getelementptr double, ptr %w14, i64 %.87.i.i
  %.92.i.i = load double, ptr %.91.i.i, align 8
  %.93.i.i = fcmp ogt double %.92.i.i, %.329.i
  br i1 %.93.i.i, label %B30.i.i, label %B32.i.i

B30.i.i:                                          ; preds = %B20.i.i, %_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i, %B120.i.i, %B86.i.i, %B32.i.i, %B834.endif.endif.i, %B936.i, %B230.outer.i
  %node.2.12.i = phi i64 [ %node.2.17.i, %B936.i ], [ %node.2.17.i, %B834.endif.endif.i ], [ %node.2.1.ph.i, %B230.outer.i ], [ %node.2.17.i, %_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i ], [ %node.2.17.i, %B120.i.i ], [ %node.2.17.i, %B86.i.i ], [ %node.2.17.i, %B32.i.i ], [ %.28.i.i, %B20.i.i ]
  %winding.3.324.i = phi i64 [ %.1759.i, %B936.i ], [ %winding.2.1.ph.i, %B834.endif.endif.i ], [ %winding.2.1.ph.i, %B230.outer.i ], [ %winding.2.1.ph.i, %B32.i.i ], [ %winding.2.1.ph.i, %B86.i.i ], [ %winding.2.1.ph.i, %B120.i.i ], [ %winding.2.1.ph.i, %_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i ], [ %winding.2.1.ph.i, %B20.i.i ]
  %.36.i.i = add nsw i64 %node.2.12.i, 1
  %9 = and i64 %node.2.12.i, 1
  %.46.not.not.i.i = icmp eq i64 %9, 0
  br i1 %.46.not.not.i.i, label %B70.i.i, label %B50.i.i

B50.i.i:                                          ; preds = %B30.i.i, %B50.i.i
  %node.3.1.i.i = phi i64 [ %.49.i.i, %B50.i.i ], [ %.36.i.i, %B30.i.i ]
  %.49.i.i = ashr i64 %node.3.1.i.i, 1
  %10 = and i64 %node.3.1.i.i, 2
  %.55.not.i.i = icmp eq i64 %10, 0
  br i1 %.55.not.i.i, label %B50.i.i, label %B70.i.i

B70.i.i:                                          ; preds = %B50.i.i, %B30.i.i
  %node.4.0.i.i = phi i64 [ %.36.i.i, %B30.i.i ], [ %.49.i.i, %B50.i.i ]
  %.60.i.i = icmp sgt i64 %node.4.0.i.i, 1
  br i1 %.60.i.i, label %B230.outer.i, label %B1008.i

B1008.i:                                          ; preds = %B70.i.i
  %.247.i = add nuw nsw i64 %.240822839.i, 1
  %11 = getelementptr i64, ptr %w19, i64 %.240822839.i
  store i64 %winding.3.324.i, ptr %11, align 8
  %exitcond.not.i = icmp eq i64 %.247.i, %w1
  br i1 %exitcond.not.i, label %_ZN7msf_jax4host5solid7kernels8windingsB3v10B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE.exit, label %B152.i

B314.endif.endif.i:                               ; preds = %B300.i
  %.536.i = sub nsw i64 %node.2.17.i, %w18
  %.564.i = getelementptr i64, ptr %w17, i64 %.536.i
  %.565.i = load i64, ptr %.564.i, align 8
  %.932.i = icmp slt i64 %.565.i, 0
  %.933.i = select i1 %.932.i, i64 %w9, i64 0
  %.934.i = add i64 %.933.i, %.565.i
  %.964.i = mul i64 %.962.i, %.934.i
  %12 = getelementptr double, ptr %w8, i64 %.964.i
  %.812.i = select i1 %.932.i, i64 %w7, i64 0
  %.idx12.i = mul i64 %.565.i, 24
  %13 = getelementptr i8, ptr %w6, i64 %.idx12.i
  %14 = getelementptr i8, ptr %13, i64 8
  %.826.i = getelementptr i64, ptr %14, i64 %.812.i
  %.827.i = load i64, ptr %.826.i, align 8
  %15 = getelementptr i8, ptr %13, i64 16
  %.860.i = getelementptr i64, ptr %15, i64 %.812.i
  %.861.i = load i64, ptr %.860.i, align 8
  %.862.i = icmp slt i64 %.827.i, %.861.i
  %16 = zext i1 %.862.i to i64
  %.966.i = shl i64 %w11, %16
  %17 = getelementptr double, ptr %w8, i64 %.966.i
  %.970.i = getelementptr double, ptr %17, i64 %.964.i
  %.971.i = load double, ptr %.970.i, align 8
  %not..862.i = xor i1 %.862.i, true
  %18 = zext i1 %not..862.i to i64
  %.1042.i = shl i64 %w11, %18
  %19 = getelementptr double, ptr %w8, i64 %.1042.i
  %.1046.i = getelementptr double, ptr %19, i64 %.964.i
  %.1047.i = load double, ptr %.1046.i, align 8
  %.1048.i = fsub double %.971.i, %.1047.i
  %.1126.i = getelementptr i8, ptr %.970.i, i64 8
  %.1127.i = load double, ptr %.1126.i, align 8
  %.1202.i = getelementptr i8, ptr %.1046.i, i64 8
  %.1203.i = load double, ptr %.1202.i, align 8
  %.1204.i = fsub double %.1127.i, %.1203.i
  %.1285.i = fsub double %.384.i, %.1203.i
  %.1287.i = fmul double %.1048.i, %.1285.i
  %.1365.i = fsub double %.329.i, %.1047.i
  %.1367.i = fmul double %.1365.i, %.1204.i
  %.1368.i = fsub double %.1287.i, %.1367.i
  %.1374.i = fcmp ogt double %.1368.i, 0.000000e+00
  br i1 %.1374.i, label %B730.i, label %B684.i

B834.endif.endif.i:                               ; preds = %B720.2.i, %B708.2.i, %B696.2.i, %B684.2.i, %B730.1.i
  %"$phi730.2.5.5.2.i" = phi i1 [ true, %B730.1.i ], [ true, %B696.2.i ], [ %.1401.2.i, %B720.2.i ], [ false, %B708.2.i ], [ false, %B684.2.i ]
  %.1437.2.i = fneg double %.1368.2.i
  %"$phi762.2.2.5.2.i" = select i1 %.862.2.i, double %.1368.2.i, double %.1437.2.i
  %.1452.2.i = fadd double %.1452.1.i, %"$phi762.2.2.5.2.i"
  %"$phi834.1.2.4.frozen.i" = freeze double %.1452.2.i
  %20 = getelementptr i8, ptr %12, i64 %.idx.i
  %.1532.2.i = getelementptr i8, ptr %20, i64 16
  %.1533.2.i = load double, ptr %.1532.2.i, align 8
  %.1534.2.i = fmul double %"$phi762.2.2.5.2.i", %.1533.2.i
  %.1536.2.i = fadd double %.1536.1.i, %.1534.2.i
  %.1548.i = fcmp une double %"$phi834.1.2.4.frozen.i", 0.000000e+00
  %.1555.i = fdiv double %.1536.2.i, %"$phi834.1.2.4.frozen.i"
  %"$phi834.1.2.4.i" = select i1 %.1548.i, double %.1555.i, double %.1536.2.i
  %sunkaddr49.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 16
  %.1632.i = load double, ptr %sunkaddr49.i, align 8
  %.10.i.i = fcmp ogt double %.1632.i, %"$phi834.1.2.4.i"
  %.11.i.i = select i1 %.10.i.i, double %.1632.i, double %"$phi834.1.2.4.i"
  %.10.i13.i = fcmp olt double %.413.i.i, %.11.i.i
  %.11.i14.i = select i1 %.10.i13.i, double %.413.i.i, double %.11.i.i
  %.1745.i = fcmp ogt double %.11.i14.i, %.439.i
  br i1 %.1745.i, label %B936.i, label %B30.i.i

_ZN7msf_jax4host5solid7kernels8windingsB3v10B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B1008.i, %0
  ret i64 0
}

declare double @llvm.fabs.f64(double)

define i64 @msf_jax.host.solid.kernels.hits(ptr readonly %words) local_unnamed_addr {
  %w0 = load ptr, ptr %words, align 8
  %p1 = getelementptr i8, ptr %words, i64 8
  %w1 = load i64, ptr %p1, align 8
  %p2 = getelementptr i8, ptr %words, i64 16
  %w2 = load i64, ptr %p2, align 8
  %p3 = getelementptr i8, ptr %words, i64 24
  %w3 = load ptr, ptr %p3, align 8
  %p7 = getelementptr i8, ptr %words, i64 56
  %w7 = load ptr, ptr %p7, align 8
  %p9 = getelementptr i8, ptr %words, i64 72
  %w9 = load double, ptr %p9, align 8
  %p15 = getelementptr i8, ptr %words, i64 120
  %w15 = load ptr, ptr %p15, align 8
  %p16 = getelementptr i8, ptr %words, i64 128
  %w16 = load i64, ptr %p16, align 8
  %p17 = getelementptr i8, ptr %words, i64 136
  %w17 = load i64, ptr %p17, align 8
  %p18 = getelementptr i8, ptr %words, i64 144
  %w18 = load i64, ptr %p18, align 8
  %p21 = getelementptr i8, ptr %words, i64 168
  %w21 = load ptr, ptr %p21, align 8
  %p22 = getelementptr i8, ptr %words, i64 176
  %w22 = load i64, ptr %p22, align 8
  %p23 = getelementptr i8, ptr %words, i64 184
  %w23 = load i64, ptr %p23, align 8
  %p24 = getelementptr i8, ptr %words, i64 192
  %w24 = load ptr, ptr %p24, align 8
  %p25 = getelementptr i8, ptr %words, i64 200
  %w25 = load i64, ptr %p25, align 8
  %p26 = getelementptr i8, ptr %words, i64 208
  %w26 = load ptr, ptr %p26, align 8
  %p29 = getelementptr i8, ptr %words, i64 232
  %w29 = load ptr, ptr %p29, align 8
  %p30 = getelementptr i8, ptr %words, i64 240
  %w30 = load i64, ptr %p30, align 8
  %p31 = getelementptr i8, ptr %words, i64 248
  %w31 = load ptr, ptr %p31, align 8
  %p32 = getelementptr i8, ptr %words, i64 256
  %w32 = load i64, ptr %p32, align 8
  %.2781694.not.i = icmp slt i64 %w1, 1
  br i1 %.2781694.not.i, label %_ZN7msf_jax4host5solid7kernels4hitsB3v14B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B122.lr.ph.i

B122.lr.ph.i:                                     ; preds = %0
  %p28 = getelementptr i8, ptr %words, i64 224
  %w28 = load i64, ptr %p28, align 8
  %s45 = shl i64 %w28, 3
  %p6 = getelementptr i8, ptr %words, i64 48
  %w6 = load i64, ptr %p6, align 8
  %p5 = getelementptr i8, ptr %words, i64 40
  %w5 = load i64, ptr %p5, align 8
  %.596.i = mul i64 %w5, %w6
  %.idx.i = shl i64 %w28, 4
  %.604.idx.i = shl i64 %w6, 4
  %invariant.gep.i = getelementptr i8, ptr %w3, i64 %.604.idx.i
  %1 = getelementptr double, ptr %w3, i64 %w6
  %sunkaddr344.i = getelementptr i8, ptr %w26, i64 8
  %sunkaddr353.i = getelementptr i8, ptr %w26, i64 16
  %sunkaddr355.i = getelementptr i8, ptr %w26, i64 %s45
  %sunkaddr358.i = getelementptr i8, ptr %sunkaddr355.i, i64 8
  %sunkaddr361.i = getelementptr i8, ptr %sunkaddr355.i, i64 16
  %sunkaddr362.i = getelementptr i8, ptr %w26, i64 %.idx.i
  %sunkaddr364.i = getelementptr i8, ptr %sunkaddr362.i, i64 8
  %sunkaddr366.i = getelementptr i8, ptr %sunkaddr362.i, i64 16
  br label %B122.endif.endif.endif.endif.endif.endif.i

B120.loopexit.i:                                  ; preds = %B70.i.i
  %.291.i = add nuw nsw i64 %.28415931699.i, 1
  %exitcond.not.i = icmp eq i64 %.291.i, %w1
  br i1 %exitcond.not.i, label %_ZN7msf_jax4host5solid7kernels4hitsB3v14B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B122.endif.endif.endif.endif.endif.endif.i

B32.i.i:                                          ; preds = %B560.outer.i, %B20.i.i
  %.87.i8.i = phi i64 [ %.87.i.i, %B20.i.i ], [ %.87.i3.i, %B560.outer.i ]
  %node.2.17.i = phi i64 [ %.28.i.i, %B20.i.i ], [ %node.2.1.ph.i, %B560.outer.i ]
  %sunkaddr.i.i = shl i64 %.87.i8.i, 3
  %sunkaddr1.i.i = getelementptr i8, ptr %w21, i64 %sunkaddr.i.i
  %sunkaddr2.i.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 8
  %.152.i.i = load double, ptr %sunkaddr2.i.i, align 8
  %.154.i.i = fcmp ogt double %.152.i.i, %.992.i
  br i1 %.154.i.i, label %B30.i.i, label %B86.i.i

B86.i.i:                                          ; preds = %B32.i.i
  %sunkaddr316.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 16
  %.214.i.i = load double, ptr %sunkaddr316.i, align 8
  %.216.i.i = fcmp ogt double %.214.i.i, %.1023.i
  br i1 %.216.i.i, label %B30.i.i, label %B92.i.i

B92.i.i:                                          ; preds = %B86.i.i
  %sunkaddr319.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 24
  %.287.i.i = load double, ptr %sunkaddr319.i, align 8
  %.289.i.i = fcmp olt double %.287.i.i, %.859.i
  br i1 %.289.i.i, label %B30.i.i, label %B120.i.i

B120.i.i:                                         ; preds = %B92.i.i
  %sunkaddr322.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 32
  %.349.i.i = load double, ptr %sunkaddr322.i, align 8
  %.351.i.i = fcmp olt double %.349.i.i, %.890.i
  br i1 %.351.i.i, label %B30.i.i, label %_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i

_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i: ; preds = %B120.i.i
  %sunkaddr325.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 40
  %.413.i.i = load double, ptr %sunkaddr325.i, align 8
  %.417.i.i = fcmp uge double %.413.i.i, %.921.i
  br i1 %.417.i.i, label %B620.i, label %B30.i.i

B620.i:                                           ; preds = %_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i
  %.1102.not.i = icmp slt i64 %node.2.17.i, %w25
  br i1 %.1102.not.i, label %B20.i.i, label %B820.endif.us.2.i

B1322.i:                                          ; preds = %B1280.endif.i, %B820.endif.us.2.i
  %.2899.i = tail call double @llvm.fabs.f64(double %.2816.i)
  %.2901.i = fmul double %.11.i279.i, 0x3D06849B86A12B9B
  %.2904.i = fcmp ogt double %.2899.i, %.2901.i
  br i1 %.2904.i, label %B1376.endif.endif.endif.endif.endif.endif.i, label %B30.i.i

B1670.i:                                          ; preds = %B1376.endif.endif.endif.endif.endif.endif.i
  %.3595.i = load double, ptr %sunkaddr327.i, align 8
  %.3597.i = fcmp ugt double %.11.i295.i, %.3595.i
  br i1 %.3597.i, label %B30.i.i, label %B1698.i

B1698.i:                                          ; preds = %B1670.i
  %.3625.i = icmp slt i64 %count.2.1.ph.i, %w30
  br i1 %.3625.i, label %B1736.i, label %B1758.i

B1736.i:                                          ; preds = %B1698.i
  %.3642.i = icmp slt i64 %count.2.1.ph.i, 0
  %.3643.i = select i1 %.3642.i, i64 %w30, i64 0
  %2 = getelementptr i64, ptr %w29, i64 %count.2.1.ph.i
  %.3657.i = getelementptr i64, ptr %2, i64 %.3643.i
  store i64 %.28415931699.i, ptr %.3657.i, align 8
  %.3675.i = select i1 %.3642.i, i64 %w32, i64 0
  %3 = getelementptr double, ptr %w31, i64 %count.2.1.ph.i
  %.3689.i = getelementptr double, ptr %3, i64 %.3675.i
  store double %.11.i295.i, ptr %.3689.i, align 8
  br label %B1758.i

B1758.i:                                          ; preds = %B1736.i, %B1698.i
  %.3697.i = add nsw i64 %count.2.1.ph.i, 1
  br label %B30.i.i

B20.i.i:                                          ; preds = %B620.i
  %.28.i.i = shl nsw i64 %node.2.17.i, 1
  %.65.i.i = icmp slt i64 %node.2.17.i, 0
  %.66.i.i = select i1 %.65.i.i, i64 %w22, i64 0
  %.67.i.i = add i64 %.66.i.i, %.28.i.i
  %.87.i.i = mul i64 %.67.i.i, %w23
  %.91.i.i = getelementptr double, ptr %w21, i64 %.87.i.i
  %.92.i.i = load double, ptr %.91.i.i, align 8
  %.93.i.i = fcmp ogt double %.92.i.i, %.961.i
  br i1 %.93.i.i, label %B30.i.i, label %B32.i.i

B30.i.i:                                          ; preds = %B20.i.i, %_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i, %B120.i.i, %B92.i.i, %B86.i.i, %B32.i.i, %B1376.endif.endif.endif.endif.endif.endif.i, %B1280.endif.i, %B560.outer.i, %B1758.i, %B1670.i, %B1322.i
  %node.2.12.i = phi i64 [ %node.2.17.i, %B1758.i ], [ %node.2.17.i, %B1280.endif.i ], [ %node.2.17.i, %B1322.i ], [ %node.2.17.i, %B1376.endif.endif.endif.endif.endif.endif.i ], [ %node.2.17.i, %B1670.i ], [ %node.2.1.ph.i, %B560.outer.i ], [ %node.2.17.i, %_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i ], [ %node.2.17.i, %B120.i.i ], [ %node.2.17.i, %B92.i.i ], [ %node.2.17.i, %B86.i.i ], [ %node.2.17.i, %B32.i.i ], [ %.28.i.i, %B20.i.i ]
  %count.3.2305.i = phi i64 [ %.3697.i, %B1758.i ], [ %count.2.1.ph.i, %B1280.endif.i ], [ %count.2.1.ph.i, %B1322.i ], [ %count.2.1.ph.i, %B1376.endif.endif.endif.endif.endif.endif.i ], [ %count.2.1.ph.i, %B1670.i ], [ %count.2.1.ph.i, %B560.outer.i ], [ %count.2.1.ph.i, %B32.i.i ], [ %count.2.1.ph.i, %B86.i.i ], [ %count.2.1.ph.i, %B92.i.i ], [ %count.2.1.ph.i, %B120.i.i ], [ %count.2.1.ph.i, %_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i ], [ %count.2.1.ph.i, %B20.i.i ]
  %.36.i.i = add nsw i64 %node.2.12.i, 1
  %4 = and i64 %node.2.12.i, 1
  %.46.not.not.i.i = icmp eq i64 %4, 0
  br i1 %.46.not.not.i.i, label %B70.i.i, label %B50.i.i

B50.i.i:                                          ; preds = %B30.i.i, %B50.i.i
  %node.3.1.i.i = phi i64 [ %.49.i.i, %B50.i.i ], [ %.36.i.i, %B30.i.i ]
  %.49.i.i = ashr i64 %node.3.1.i.i, 1
  %5 = and i64 %node.3.1.i.i, 2
  %.55.not.i.i = icmp eq i64 %5, 0
  br i1 %.55.not.i.i, label %B50.i.i, label %B70.i.i

B70.i.i:                                          ; preds = %B50.i.i, %B30.i.i
  %node.4.0.i.i = phi i64 [ %.36.i.i, %B30.i.i ], [ %.49.i.i, %B50.i.i ]
  %.60.i.i = icmp sgt i64 %node.4.0.i.i, 1
  br i1 %.60.i.i, label %B560.outer.i, label %B120.loopexit.i

B122.endif.endif.endif.endif.endif.endif.i:       ; preds = %B120.loopexit.i, %B122.lr.ph.i
  %count.4.01701.i = phi i64 [ 0, %B122.lr.ph.i ], [ %count.3.2305.i, %B120.loopexit.i ]
  %.28415931699.i = phi i64 [ 0, %B122.lr.ph.i ], [ %.291.i, %B120.loopexit.i ]
  %.374.i = mul i64 %.28415931699.i, %w2
  %.378.i = getelementptr double, ptr %w0, i64 %.374.i
  %.379.i = load double, ptr %.378.i, align 8
  %.433.i = getelementptr i8, ptr %.378.i, i64 8
  %.434.i = load double, ptr %.433.i, align 8
  %.488.i = getelementptr i8, ptr %.378.i, i64 16
  %.489.i = load double, ptr %.488.i, align 8
  %6 = getelementptr double, ptr %w7, i64 %.28415931699.i
  %.529.i = load double, ptr %6, align 8
  %.598.i = mul i64 %.596.i, %.28415931699.i
  %gep.i = getelementptr double, ptr %invariant.gep.i, i64 %.598.i
  %.605.i = load double, ptr %gep.i, align 8
  %.606.i = fmul double %.529.i, %.605.i
  %.608.i = fadd double %.379.i, %.606.i
  %.714.i = getelementptr i8, ptr %gep.i, i64 8
  %.715.i = load double, ptr %.714.i, align 8
  %.716.i = fmul double %.529.i, %.715.i
  %.718.i = fadd double %.434.i, %.716.i
  %.824.i = getelementptr i8, ptr %gep.i, i64 16
  %.825.i = load double, ptr %.824.i, align 8
  %.826.i = fmul double %.529.i, %.825.i
  %.828.i = fadd double %.489.i, %.826.i
  %.10.i.i = fcmp olt double %.608.i, %.379.i
  %.11.i.i = select i1 %.10.i.i, double %.608.i, double %.379.i
  %.859.i = fsub double %.11.i.i, %w9
  %.10.i153.i = fcmp olt double %.718.i, %.434.i
  %.11.i154.i = select i1 %.10.i153.i, double %.718.i, double %.434.i
  %.890.i = fsub double %.11.i154.i, %w9
  %.10.i155.i = fcmp olt double %.828.i, %.489.i
  %.11.i156.i = select i1 %.10.i155.i, double %.828.i, double %.489.i
  %.921.i = fsub double %.11.i156.i, %w9
  %.10.i157.i = fcmp ogt double %.608.i, %.379.i
  %.11.i158.i = select i1 %.10.i157.i, double %.608.i, double %.379.i
  %.961.i = fadd double %w9, %.11.i158.i
  %.10.i159.i = fcmp ogt double %.718.i, %.434.i
  %.11.i160.i = select i1 %.10.i159.i, double %.718.i, double %.434.i
  %.992.i = fadd double %w9, %.11.i160.i
  %.10.i161.i = fcmp ogt double %.828.i, %.489.i
  %.11.i162.i = select i1 %.10.i161.i, double %.828.i, double %.489.i
  %.1023.i = fadd double %w9, %.11.i162.i
  %sunkaddr328.i = shl i64 %.598.i, 3
  %sunkaddr329.i = getelementptr i8, ptr %w3, i64 %sunkaddr328.i
  %sunkaddr332.i = getelementptr i8, ptr %sunkaddr329.i, i64 8
  %sunkaddr335.i = getelementptr i8, ptr %sunkaddr329.i, i64 16
  %sunkaddr337.i = getelementptr inbounds i8, ptr %1, i64 %sunkaddr328.i
  %sunkaddr340.i = getelementptr i8, ptr %sunkaddr337.i, i64 8
  %sunkaddr343.i = getelementptr i8, ptr %sunkaddr337.i, i64 16
  %sunkaddr346.i = getelementptr inbounds i8, ptr %invariant.gep.i, i64 %sunkaddr328.i
  %sunkaddr349.i = getelementptr i8, ptr %sunkaddr346.i, i64 8
  %sunkaddr352.i = getelementptr i8, ptr %sunkaddr346.i, i64 16
  %sunkaddr326.i = shl i64 %.28415931699.i, 3
  %sunkaddr327.i = getelementptr i8, ptr %w7, i64 %sunkaddr326.i
  br label %B560.outer.i

B560.outer.i:                                     ; preds = %B122.endif.endif.endif.endif.endif.endif.i, %B70.i.i
  %count.2.1.ph.i = phi i64 [ %count.3.2305.i, %B70.i.i ], [ %count.4.01701.i, %B122.endif.endif.endif.endif.endif.endif.i ]
  %node.2.1.ph.i = phi i64 [ %node.4.0.i.i, %B70.i.i ], [ 1, %B122.endif.endif.endif.endif.endif.endif.i ]
  %.87.i3.i = mul i64 %node.2.1.ph.i, %w23
  %.91.i4.i = getelementptr double, ptr %w21, i64 %.87.i3.i
  %.92.i5.i = load double, ptr %.91.i4.i, align 8
  %.93.i6.i = fcmp ogt double %.92.i5.i, %.961.i
  br i1 %.93.i6.i, label %B30.i.i, label %B32.i.i

B820.endif.us.2.i:                                ; preds = %B620.i
  %.1110.i = sub nsw i64 %node.2.17.i, %w25
  %.1138.i = getelementptr i64, ptr %w24, i64 %.1110.i
  %.1139.i = load i64, ptr %.1138.i, align 8
  %.1303.i = icmp slt i64 %.1139.i, 0
  %.1304.i = select i1 %.1303.i, i64 %w16, i64 0
  %.1305.i = add i64 %.1304.i, %.1139.i
  %.1335.i = mul i64 %.1305.i, %w17
  %reass.mul.us.i = mul i64 %.1335.i, %w18
  %.1341.us.i = getelementptr double, ptr %w15, i64 %reass.mul.us.i
  %.1342.us.i = load double, ptr %.1341.us.i, align 8
  %.1344.us.i = fsub double %.1342.us.i, %.379.i
  %.1420.us.i = getelementptr i8, ptr %.1341.us.i, i64 8
  %.1421.us.i = load double, ptr %.1420.us.i, align 8
  %.1423.us.i = fsub double %.1421.us.i, %.434.i
  %.1499.us.i = getelementptr i8, ptr %.1341.us.i, i64 16
  %.1500.us.i = load double, ptr %.1499.us.i, align 8
  %.1502.us.i = fsub double %.1500.us.i, %.489.i
  %.1705.us.i = load double, ptr %sunkaddr329.i, align 8
  %.1781.us.i = load double, ptr %sunkaddr332.i, align 8
  %.1857.us.i = load double, ptr %sunkaddr335.i, align 8
  %.10.i163.i = fmul double %.1344.us.i, %.1705.us.i
  %.11.i164.i = fmul double %.1502.us.i, %.1857.us.i
  %.12.i165.i = fadd double %.10.i163.i, %.11.i164.i
  %.13.i166.i = fmul double %.1423.us.i, %.1781.us.i
  %.14.i167.i = fadd double %.13.i166.i, %.12.i165.i
  store double %.14.i167.i, ptr %w26, align 8
  %.1705.us.1.i = load double, ptr %sunkaddr337.i, align 8
  %.1781.us.1.i = load double, ptr %sunkaddr340.i, align 8
  %.1857.us.1.i = load double, ptr %sunkaddr343.i, align 8
  %.10.i171.i = fmul double %.1344.us.i, %.1705.us.1.i
  %.11.i172.i = fmul double %.1502.us.i, %.1857.us.1.i
  %.12.i173.i = fadd double %.10.i171.i, %.11.i172.i
  %.13.i174.i = fmul double %.1423.us.i, %.1781.us.1.i
  %.14.i175.i = fadd double %.13.i174.i, %.12.i173.i
  store double %.14.i175.i, ptr %sunkaddr344.i, align 8
  %.1705.us.2.i = load double, ptr %sunkaddr346.i, align 8
  %.1781.us.2.i = load double, ptr %sunkaddr349.i, align 8
  %.1857.us.2.i = load double, ptr %sunkaddr352.i, align 8
  %.10.i176.i = fmul double %.1344.us.i, %.1705.us.2.i
  %.11.i177.i = fmul double %.1502.us.i, %.1857.us.2.i
  %.12.i178.i = fadd double %.10.i176.i, %.11.i177.i
  %.13.i179.i = fmul double %.1423.us.i, %.1781.us.2.i
  %.14.i180.i = fadd double %.13.i179.i, %.12.i178.i
  store double %.14.i180.i, ptr %sunkaddr353.i, align 8
  %.1308.us.1.i = add i64 %.1335.i, 1
  %reass.mul.us.1.i = mul i64 %.1308.us.1.i, %w18
  %.1341.us.1.i = getelementptr double, ptr %w15, i64 %reass.mul.us.1.i
  %.1342.us.1.i = load double, ptr %.1341.us.1.i, align 8
  %.1344.us.1.i = fsub double %.1342.us.1.i, %.379.i
  %.1420.us.1.i = getelementptr i8, ptr %.1341.us.1.i, i64 8
  %.1421.us.1.i = load double, ptr %.1420.us.1.i, align 8
  %.1423.us.1.i = fsub double %.1421.us.1.i, %.434.i
  %.1499.us.1.i = getelementptr i8, ptr %.1341.us.1.i, i64 16
  %.1500.us.1.i = load double, ptr %.1499.us.1.i, align 8
  %.1502.us.1.i = fsub double %.1500.us.1.i, %.489.i
  %.1705.us.12031.i = load double, ptr %sunkaddr329.i, align 8
  %.1781.us.12033.i = load double, ptr %sunkaddr332.i, align 8
  %.1857.us.12035.i = load double, ptr %sunkaddr335.i, align 8
  %.10.i194.i = fmul double %.1344.us.1.i, %.1705.us.12031.i
  %.11.i195.i = fmul double %.1502.us.1.i, %.1857.us.12035.i
  %.12.i196.i = fadd double %.10.i194.i, %.11.i195.i
  %.13.i197.i = fmul double %.1423.us.1.i, %.1781.us.12033.i
  %.14.i198.i = fadd double %.13.i197.i, %.12.i196.i
  store double %.14.i198.i, ptr %sunkaddr355.i, align 8
  %.1705.us.1.1.i = load double, ptr %sunkaddr337.i, align 8
  %.1781.us.1.1.i = load double, ptr %sunkaddr340.i, align 8
  %.1857.us.1.1.i = load double, ptr %sunkaddr343.i, align 8
  %.10.i199.i = fmul double %.1344.us.1.i, %.1705.us.1.1.i
  %.11.i200.i = fmul double %.1502.us.1.i, %.1857.us.1.1.i
  %.12.i201.i = fadd double %.10.i199.i, %.11.i200.i
  %.13.i202.i = fmul double %.1423.us.1.i, %.1781.us.1.1.i
  %.14.i203.i = fadd double %.13.i202.i, %.12.i201.i
  store double %.14.i203.i, ptr %sunkaddr358.i, align 8
  %.1705.us.2.1.i = load double, ptr %sunkaddr346.i, align 8
  %.1781.us.2.1.i = load double, ptr %sunkaddr349.i, align 8
  %.1857.us.2.1.i = load double, ptr %sunkaddr352.i, align 8
  %.10.i204.i = fmul double %.1344.us.1.i, %.1705.us.2.1.i
  %.11.i205.i = fmul double %.1502.us.1.i, %.1857.us.2.1.i
  %.12.i206.i = fadd double %.10.i204.i, %.11.i205.i
  %.13.i207.i = fmul double %.1423.us.1.i, %.1781.us.2.1.i
  %.14.i208.i = fadd double %.13.i207.i, %.12.i206.i
  store double %.14.i208.i, ptr %sunkaddr361.i, align 8
  %.1308.us.2.i = add i64 %.1335.i, 2
  %reass.mul.us.2.i = mul i64 %.1308.us.2.i, %w18
  %.1341.us.2.i = getelementptr double, ptr %w15, i64 %reass.mul.us.2.i
  %.1342.us.2.i = load double, ptr %.1341.us.2.i, align 8
  %.1344.us.2.i = fsub double %.1342.us.2.i, %.379.i
  %.1420.us.2.i = getelementptr i8, ptr %.1341.us.2.i, i64 8
  %.1421.us.2.i = load double, ptr %.1420.us.2.i, align 8
  %.1423.us.2.i = fsub double %.1421.us.2.i, %.434.i
  %.1499.us.2.i = getelementptr i8, ptr %.1341.us.2.i, i64 16
  %.1500.us.2.i = load double, ptr %.1499.us.2.i, align 8
  %.1502.us.2.i = fsub double %.1500.us.2.i, %.489.i
  %.1705.us.22040.i = load double, ptr %sunkaddr329.i, align 8
  %.1781.us.22042.i = load double, ptr %sunkaddr332.i, align 8
  %.1857.us.22044.i = load double, ptr %sunkaddr335.i, align 8
  %.10.i237.i = fmul double %.1344.us.2.i, %.1705.us.22040.i
  %.11.i238.i = fmul double %.1502.us.2.i, %.1857.us.22044.i
  %.12.i239.i = fadd double %.10.i237.i, %.11.i238.i
  %.13.i240.i = fmul double %.1423.us.2.i, %.1781.us.22042.i
  %.14.i241.i = fadd double %.13.i240.i, %.12.i239.i
  store double %.14.i241.i, ptr %sunkaddr362.i, align 8
  %.1705.us.1.2.i = load double, ptr %sunkaddr337.i, align 8
  %.1781.us.1.2.i = load double, ptr %sunkaddr340.i, align 8
  %.1857.us.1.2.i = load double, ptr %sunkaddr343.i, align 8
  %.10.i242.i = fmul double %.1344.us.2.i, %.1705.us.1.2.i
  %.11.i243.i = fmul double %.1502.us.2.i, %.1857.us.1.2.i
  %.12.i244.i = fadd double %.10.i242.i, %.11.i243.i
  %.13.i245.i = fmul double %.1423.us.2.i, %.1781.us.1.2.i
  %.14.i246.i = fadd double %.13.i245.i, %.12.i244.i
  store double %.14.i246.i, ptr %sunkaddr364.i, align 8
  %.1705.us.2.2.i = load double, ptr %sunkaddr346.i, align 8
  %.1781.us.2.2.i = load double, ptr %sunkaddr349.i, align 8
  %.1857.us.2.2.i = load double, ptr %sunkaddr352.i, align 8
  %.10.i247.i = fmul double %.1344.us.2.i, %.1705.us.2.2.i
  %.11.i248.i = fmul double %.1502.us.2.i, %.1857.us.2.2.i
  %.12.i249.i = fadd double %.10.i247.i, %.11.i248.i
  %.13.i250.i = fmul double %.1423.us.2.i, %.1781.us.2.2.i
  %.14.i251.i = fadd double %.13.i250.i, %.12.i249.i
  store double %.14.i251.i, ptr %sunkaddr366.i, align 8
  %.147.i275.i = fmul double %.14.i246.i, %.14.i246.i
  %.147.i262.i = fmul double %.14.i241.i, %.14.i241.i
  %.147.i232.i = fmul double %.14.i203.i, %.14.i203.i
  %.147.i219.i = fmul double %.14.i198.i, %.14.i198.i
  %.147.i.i = fmul double %.14.i175.i, %.14.i175.i
  %.147.i191.i = fmul double %.14.i167.i, %.14.i167.i
  %.2107.us.i = fadd double %.147.i191.i, %.147.i.i
  %.10.i169.i = fcmp ogt double %.2107.us.i, 0.000000e+00
  %.11.i170.i = select i1 %.10.i169.i, double %.2107.us.i, double 0.000000e+00
  %.2107.us.1.i = fadd double %.147.i219.i, %.147.i232.i
  %.10.i235.i = fcmp ogt double %.2107.us.1.i, %.11.i170.i
  %.11.i236.i = select i1 %.10.i235.i, double %.2107.us.1.i, double %.11.i170.i
  %.2107.us.2.i = fadd double %.147.i262.i, %.147.i275.i
  %.10.i278.i = fcmp ogt double %.2107.us.2.i, %.11.i236.i
  %.11.i279.i = select i1 %.10.i278.i, double %.2107.us.2.i, double %.11.i236.i
  %.2199.i = load double, ptr %w26, align 8
  %.2253.i = load double, ptr %sunkaddr358.i, align 8
  %.2254.i = fmul double %.2199.i, %.2253.i
  %.2308.i = load double, ptr %sunkaddr355.i, align 8
  %.2362.i = load double, ptr %sunkaddr344.i, align 8
  %.2363.i = fmul double %.2308.i, %.2362.i
  %.2364.i = fsub double %.2254.i, %.2363.i
  %.2476.i = fmul double %.14.i246.i, %.2308.i
  %.2585.i = fmul double %.14.i241.i, %.2253.i
  %.2586.i = fsub double %.2476.i, %.2585.i
  %.2698.i = fmul double %.14.i241.i, %.2362.i
  %.2807.i = fmul double %.14.i246.i, %.2199.i
  %.2808.i = fsub double %.2698.i, %.2807.i
  %.2814.i = fadd double %.2586.i, %.2364.i
  %.2816.i = fadd double %.2808.i, %.2814.i
  %.13.i280.i = fcmp olt double %.2586.i, %.2364.i
  %.14.i281.i = select i1 %.13.i280.i, double %.2586.i, double %.2364.i
  %.15.i282.i = fcmp olt double %.2808.i, %.14.i281.i
  %.16.i283.i = select i1 %.15.i282.i, double %.2808.i, double %.14.i281.i
  %.2854.i = fcmp ult double %.16.i283.i, 0.000000e+00
  br i1 %.2854.i, label %B1280.endif.i, label %B1322.i

B1280.endif.i:                                    ; preds = %B820.endif.us.2.i
  %.13.i.i = fcmp ogt double %.2586.i, %.2364.i
  %.14.i.i = select i1 %.13.i.i, double %.2586.i, double %.2364.i
  %.15.i.i = fcmp ogt double %.2808.i, %.14.i.i
  %.16.i.i = select i1 %.15.i.i, double %.2808.i, double %.14.i.i
  %.2893.i = fcmp ugt double %.16.i.i, 0.000000e+00
  br i1 %.2893.i, label %B30.i.i, label %B1322.i

B1376.endif.endif.endif.endif.endif.endif.i:      ; preds = %B1322.i
  %.3016.i = load double, ptr %sunkaddr353.i, align 8
  %.3070.i = load double, ptr %sunkaddr361.i, align 8
  %.10.i149.i = fmul double %.14.i251.i, %.2364.i
  %.11.i150.i = fmul double %.2808.i, %.3070.i
  %.12.i.i = fadd double %.10.i149.i, %.11.i150.i
  %.13.i151.i = fmul double %.2586.i, %.3016.i
  %.14.i152.i = fadd double %.13.i151.i, %.12.i.i
  %.13.i284.i = fcmp olt double %.3070.i, %.3016.i
  %.14.i285.i = select i1 %.13.i284.i, double %.3070.i, double %.3016.i
  %.15.i286.i = fcmp olt double %.14.i251.i, %.14.i285.i
  %.16.i287.i = select i1 %.15.i286.i, double %.14.i251.i, double %.14.i285.i
  %.3108.i = fdiv double %.14.i152.i, %.2816.i
  %.10.i288.i = fcmp ogt double %.16.i287.i, %.3108.i
  %.11.i289.i = select i1 %.10.i288.i, double %.16.i287.i, double %.3108.i
  %.13.i290.i = fcmp ogt double %.3070.i, %.3016.i
  %.14.i291.i = select i1 %.13.i290.i, double %.3070.i, double %.3016.i
  %.15.i292.i = fcmp ogt double %.14.i251.i, %.14.i291.i
  %.16.i293.i = select i1 %.15.i292.i, double %.14.i251.i, double %.14.i291.i
  %.10.i294.i = fcmp olt double %.16.i293.i, %.11.i289.i
  %.11.i295.i = select i1 %.10.i294.i, double %.16.i293.i, double %.11.i289.i
  %.3556.i = fcmp ult double %.11.i295.i, 0.000000e+00
  br i1 %.3556.i, label %B30.i.i, label %B1670.i

_ZN7msf_jax4host5solid7kernels4hitsB3v14B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B120.loopexit.i, %0
  %count.4.0.lcssa.i = phi i64 [ 0, %0 ], [ %count.3.2305.i, %B120.loopexit.i ]
  ret i64 %count.4.0.lcssa.i
}

define internal fastcc void @_ZN7msf_jax4host5solid7kernels9straddlesB3v19B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi3E1C7mutable7alignedExxd(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.triangles.4, i64 %arg.triangles.5.0, i64 %arg.triangles.5.1, i64 %arg.triangles.5.2, i64 %arg.row, i64 %arg.other, double %arg.least) unnamed_addr {
B0:
  %.58.i = icmp slt i64 %arg.row, 0
  %.59.i = select i1 %.58.i, i64 %arg.triangles.5.0, i64 0
  %.60.i = add i64 %.59.i, %arg.row
  %.88.i = mul i64 %arg.triangles.5.2, %arg.triangles.5.1
  %.90.i = mul i64 %.60.i, %.88.i
  %.96.i = getelementptr double, ptr %arg.triangles.4, i64 %.90.i
  %.97.i = load double, ptr %.96.i, align 8
  %.170.i = getelementptr i8, ptr %.96.i, i64 8
  %.171.i = load double, ptr %.170.i, align 8
  %.244.i = getelementptr i8, ptr %.96.i, i64 16
  %.245.i = load double, ptr %.244.i, align 8
  %.318.i = getelementptr double, ptr %.96.i, i64 %arg.triangles.5.2
  %.319.i = load double, ptr %.318.i, align 8
  %.320.i = fsub double %.319.i, %.97.i
  %.393.i = getelementptr i8, ptr %.318.i, i64 8
  %.394.i = load double, ptr %.393.i, align 8
  %.395.i = fsub double %.394.i, %.171.i
  %.468.i = getelementptr i8, ptr %.318.i, i64 16
  %.469.i = load double, ptr %.468.i, align 8
  %.470.i = fsub double %.469.i, %.245.i
  %.543.idx.i = shl i64 %arg.triangles.5.2, 4
  %.543.i = getelementptr i8, ptr %.96.i, i64 %.543.idx.i
  %.544.i = load double, ptr %.543.i, align 8
  %.545.i = fsub double %.544.i, %.97.i
  %.618.i = getelementptr i8, ptr %.543.i, i64 8
  %.619.i = load double, ptr %.618.i, align 8
  %.620.i = fsub double %.619.i, %.171.i
  %.693.i = getelementptr i8, ptr %.543.i, i64 16
  %.694.i = load double, ptr %.693.i, align 8
  %.695.i = fsub double %.694.i, %.245.i
  %.696.i = fmul double %.395.i, %.695.i
  %.697.i = fmul double %.470.i, %.620.i
  %.698.i = fsub double %.696.i, %.697.i
  %.699.i = fmul double %.470.i, %.545.i
  %.700.i = fmul double %.320.i, %.695.i
  %.701.i = fsub double %.699.i, %.700.i
  %.702.i = fmul double %.320.i, %.620.i
  %.703.i = fmul double %.395.i, %.545.i
  %.704.i = fsub double %.702.i, %.703.i
  %.7.i.i = fmul double %.698.i, %.698.i
  %.8.i.i = fmul double %.701.i, %.701.i
  %.9.i.i = fadd double %.7.i.i, %.8.i.i
  %.10.i.i = fmul double %.704.i, %.704.i
  %.11.i.i = fadd double %.10.i.i, %.9.i.i
  %.983.i = fcmp ogt double %.11.i.i, 0.000000e+00
  br i1 %.983.i, label %B434.endif.endif.i47, label %B0.endif.endif

common.ret:                                       ; preds = %B156.endif, %B0.endif.endif.endif.endif
  %"$phi196.0.2.0" = phi i8 [ %4, %B156.endif ], [ 0, %B0.endif.endif.endif.endif ]
  store i8 %"$phi196.0.2.0", ptr %retptr, align 1
  ret void

B434.endif.endif.i47:                             ; preds = %B0
  %sqrt.i.i = tail call double @llvm.sqrt.f64(double %.11.i.i)
  %.781.i = icmp slt i64 %arg.other, 0
  %.782.i = select i1 %.781.i, i64 %arg.triangles.5.0, i64 0
  %.783.i = add i64 %.782.i, %arg.other
  %.813.i = mul i64 %.783.i, %.88.i
  %0 = getelementptr double, ptr %arg.triangles.4, i64 %.813.i
  %.969.i = getelementptr i8, ptr %0, i64 16
  %.970.i = load double, ptr %.969.i, align 8
  %.971.i = fsub double %.970.i, %.245.i
  %.894.i = getelementptr i8, ptr %0, i64 8
  %.895.i = load double, ptr %.894.i, align 8
  %.896.i = fsub double %.895.i, %.171.i
  %.820.i = load double, ptr %0, align 8
  %.821.i = fsub double %.820.i, %.97.i
  %.10.i1.i = fmul double %.698.i, %.821.i
  %.11.i2.i = fmul double %.704.i, %.971.i
  %.12.i.i = fadd double %.11.i2.i, %.10.i1.i
  %.13.i.i = fmul double %.701.i, %.896.i
  %.14.i.i = fadd double %.13.i.i, %.12.i.i
  %.1032.i = fdiv double %.14.i.i, %sqrt.i.i
  %1 = getelementptr double, ptr %0, i64 %arg.triangles.5.2
  %.969.i53 = getelementptr i8, ptr %1, i64 16
  %.970.i54 = load double, ptr %.969.i53, align 8
  %.971.i55 = fsub double %.970.i54, %.245.i
  %.894.i56 = getelementptr i8, ptr %1, i64 8
  %.895.i57 = load double, ptr %.894.i56, align 8
  %.896.i58 = fsub double %.895.i57, %.171.i
  %.820.i59 = load double, ptr %1, align 8
  %.821.i60 = fsub double %.820.i59, %.97.i
  %.10.i1.i61 = fmul double %.698.i, %.821.i60
  %.11.i2.i62 = fmul double %.704.i, %.971.i55
  %.12.i.i63 = fadd double %.11.i2.i62, %.10.i1.i61
  %.13.i.i64 = fmul double %.701.i, %.896.i58
  %.14.i.i65 = fadd double %.13.i.i64, %.12.i.i63
  %.1032.i66 = fdiv double %.14.i.i65, %sqrt.i.i
  br label %B0.endif.endif

B0.endif.endif:                                   ; preds = %B434.endif.endif.i47, %B0
  %"$phi482.0.2.0.i137" = phi double [ %.1032.i, %B434.endif.endif.i47 ], [ 0.000000e+00, %B0 ]
  %"$phi482.0.2.0.i46" = phi double [ %.1032.i66, %B434.endif.endif.i47 ], [ 0.000000e+00, %B0 ]
  %.539.i = shl i64 %arg.triangles.5.2, 1
  %.543.i87 = getelementptr double, ptr %.96.i, i64 %.539.i
  %.544.i88 = load double, ptr %.543.i87, align 8
  %.545.i89 = fsub double %.544.i88, %.97.i
  %.618.i90 = getelementptr i8, ptr %.543.i87, i64 8
  %.619.i91 = load double, ptr %.618.i90, align 8
  %.620.i92 = fsub double %.619.i91, %.171.i
  %.693.i93 = getelementptr i8, ptr %.543.i87, i64 16
  %.694.i94 = load double, ptr %.693.i93, align 8
  %.695.i95 = fsub double %.694.i94, %.245.i
  %.696.i96 = fmul double %.395.i, %.695.i95
  %.697.i97 = fmul double %.470.i, %.620.i92
  %.698.i98 = fsub double %.696.i96, %.697.i97
  %.699.i99 = fmul double %.470.i, %.545.i89
  %.700.i100 = fmul double %.320.i, %.695.i95
  %.701.i101 = fsub double %.699.i99, %.700.i100
  %.702.i102 = fmul double %.320.i, %.620.i92
  %.703.i103 = fmul double %.395.i, %.545.i89
  %.704.i104 = fsub double %.702.i102, %.703.i103
  %.7.i.i105 = fmul double %.698.i98, %.698.i98
  %.8.i.i106 = fmul double %.701.i101, %.701.i101
  %.9.i.i107 = fadd double %.7.i.i105, %.8.i.i106
  %.10.i.i108 = fmul double %.704.i104, %.704.i104
  %.11.i.i109 = fadd double %.10.i.i108, %.9.i.i107
  %.983.i110 = fcmp ogt double %.11.i.i109, 0.000000e+00
  br i1 %.983.i110, label %B434.endif.endif.i112, label %B0.endif.endif.endif.endif

B434.endif.endif.i112:                            ; preds = %B0.endif.endif
  %sqrt.i.i113 = tail call double @llvm.sqrt.f64(double %.11.i.i109)
  %.781.i114 = icmp slt i64 %arg.other, 0
  %.782.i115 = select i1 %.781.i114, i64 %arg.triangles.5.0, i64 0
  %.783.i116 = add i64 %.782.i115, %arg.other
  %.813.i117 = mul i64 %.783.i116, %.88.i
  %2 = getelementptr double, ptr %arg.triangles.4, i64 %.813.i117
  %3 = getelementptr double, ptr %2, i64 %.539.i
  %.969.i118 = getelementptr i8, ptr %3, i64 16
  %.970.i119 = load double, ptr %.969.i118, align 8
  %.971.i120 = fsub double %.970.i119, %.245.i
  %.894.i121 = getelementptr i8, ptr %3, i64 8
  %.895.i122 = load double, ptr %.894.i121, align 8
  %.896.i123 = fsub double %.895.i122, %.171.i
  %.820.i124 = load double, ptr %3, align 8
  %.821.i125 = fsub double %.820.i124, %.97.i
  %.10.i1.i126 = fmul double %.698.i98, %.821.i125
  %.11.i2.i127 = fmul double %.704.i104, %.971.i120
  %.12.i.i128 = fadd double %.11.i2.i127, %.10.i1.i126
  %.13.i.i129 = fmul double %.701.i101, %.896.i123
  %.14.i.i130 = fadd double %.13.i.i129, %.12.i.i128
  %.1032.i131 = fdiv double %.14.i.i130, %sqrt.i.i113
  br label %B0.endif.endif.endif.endif

B0.endif.endif.endif.endif:                       ; preds = %B434.endif.endif.i112, %B0.endif.endif
  %"$phi482.0.2.0.i111" = phi double [ %.1032.i131, %B434.endif.endif.i112 ], [ 0.000000e+00, %B0.endif.endif ]
  %.13.i132 = fcmp olt double %"$phi482.0.2.0.i46", %"$phi482.0.2.0.i137"
  %.14.i133 = select i1 %.13.i132, double %"$phi482.0.2.0.i46", double %"$phi482.0.2.0.i137"
  %.15.i134 = fcmp olt double %"$phi482.0.2.0.i111", %.14.i133
  %.16.i135 = select i1 %.15.i134, double %"$phi482.0.2.0.i111", double %.14.i133
  %.164 = fneg double %arg.least
  %.165 = fcmp olt double %.16.i135, %.164
  br i1 %.165, label %B156.endif, label %common.ret

B156.endif:                                       ; preds = %B0.endif.endif.endif.endif
  %.13.i = fcmp ogt double %"$phi482.0.2.0.i46", %"$phi482.0.2.0.i137"
  %.14.i = select i1 %.13.i, double %"$phi482.0.2.0.i46", double %"$phi482.0.2.0.i137"
  %.15.i = fcmp ogt double %"$phi482.0.2.0.i111", %.14.i
  %.16.i = select i1 %.15.i, double %"$phi482.0.2.0.i111", double %.14.i
  %.210 = fcmp ogt double %.16.i, %arg.least
  %4 = zext i1 %.210 to i8
  br label %common.ret
}

define internal fastcc void @_ZN7msf_jax4host5solid7kernels6passesB3v24B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi3E1C7mutable7alignedExxxd(ptr noalias nonnull writeonly %retptr, ptr readonly %arg.triangles.4, i64 %arg.triangles.5.0, i64 %arg.triangles.5.1, i64 %arg.triangles.5.2, i64 %arg.row, i64 %arg.k, i64 %arg.other, double %arg.least) unnamed_addr {
B0.else.if:
  %arg.k.fr = freeze i64 %arg.k
  %.36 = add i64 %arg.k.fr, 1
  %0 = icmp eq i64 %.36, 3
  %.56 = select i1 %0, i64 0, i64 %.36
  %.58.i = icmp slt i64 %arg.other, 0
  %.59.i = select i1 %.58.i, i64 %arg.triangles.5.0, i64 0
  %.60.i = add i64 %.59.i, %arg.other
  %.88.i = mul i64 %arg.triangles.5.2, %arg.triangles.5.1
  %.90.i = mul i64 %.60.i, %.88.i
  %.96.i = getelementptr double, ptr %arg.triangles.4, i64 %.90.i
  %.97.i = load double, ptr %.96.i, align 8
  %.170.i = getelementptr i8, ptr %.96.i, i64 8
  %.171.i = load double, ptr %.170.i, align 8
  %.244.i = getelementptr i8, ptr %.96.i, i64 16
  %.245.i = load double, ptr %.244.i, align 8
  %.318.i = getelementptr double, ptr %.96.i, i64 %arg.triangles.5.2
  %.319.i = load double, ptr %.318.i, align 8
  %.320.i = fsub double %.319.i, %.97.i
  %.393.i = getelementptr i8, ptr %.318.i, i64 8
  %.394.i = load double, ptr %.393.i, align 8
  %.395.i = fsub double %.394.i, %.171.i
  %.468.i = getelementptr i8, ptr %.318.i, i64 16
  %.469.i = load double, ptr %.468.i, align 8
  %.470.i = fsub double %.469.i, %.245.i
  %.543.idx.i = shl i64 %arg.triangles.5.2, 4
  %.543.i = getelementptr i8, ptr %.96.i, i64 %.543.idx.i
  %.544.i = load double, ptr %.543.i, align 8
  %.545.i = fsub double %.544.i, %.97.i
  %.618.i = getelementptr i8, ptr %.543.i, i64 8
  %.619.i = load double, ptr %.618.i, align 8
  %.620.i = fsub double %.619.i, %.171.i
  %.693.i = getelementptr i8, ptr %.543.i, i64 16
  %.694.i = load double, ptr %.693.i, align 8
  %.695.i = fsub double %.694.i, %.245.i
  %.696.i = fmul double %.395.i, %.695.i
  %.697.i = fmul double %.470.i, %.620.i
  %.698.i = fsub double %.696.i, %.697.i
  %.699.i = fmul double %.470.i, %.545.i
  %.700.i = fmul double %.320.i, %.695.i
  %.701.i = fsub double %.699.i, %.700.i
  %.702.i = fmul double %.320.i, %.620.i
  %.703.i = fmul double %.395.i, %.545.i
  %.704.i = fsub double %.702.i, %.703.i
  %.7.i.i = fmul double %.698.i, %.698.i
  %.8.i.i = fmul double %.701.i, %.701.i
  %.9.i.i = fadd double %.7.i.i, %.8.i.i
  %.10.i.i = fmul double %.704.i, %.704.i
  %.11.i.i = fadd double %.10.i.i, %.9.i.i
  %.983.i = fcmp ogt double %.11.i.i, 0.000000e+00
  br i1 %.983.i, label %B434.endif.endif.i47, label %B0.endif.endif.endif.endif

common.ret:                                       ; preds = %B368.endif.endif.2, %B134.endif, %B0.endif.endif.endif.endif
  %storemerge = phi i8 [ %.1468, %B368.endif.endif.2 ], [ 0, %B134.endif ], [ 0, %B0.endif.endif.endif.endif ]
  store i8 %storemerge, ptr %retptr, align 1
  ret void

B434.endif.endif.i47:                             ; preds = %B0.else.if
  %sqrt.i.i = tail call double @llvm.sqrt.f64(double %.11.i.i)
  %.781.i = icmp slt i64 %arg.row, 0
  %.782.i = select i1 %.781.i, i64 %arg.triangles.5.0, i64 0
  %.783.i = add i64 %.782.i, %arg.row
  %.813.i = mul i64 %.783.i, %.88.i
  %.815.i = mul i64 %arg.k.fr, %arg.triangles.5.2
  %1 = getelementptr double, ptr %arg.triangles.4, i64 %.815.i
  %2 = getelementptr double, ptr %1, i64 %.813.i
  %.969.i = getelementptr i8, ptr %2, i64 16
  %.970.i = load double, ptr %.969.i, align 8
  %.971.i = fsub double %.970.i, %.245.i
  %.894.i = getelementptr i8, ptr %2, i64 8
  %.895.i = load double, ptr %.894.i, align 8
  %.896.i = fsub double %.895.i, %.171.i
  %.820.i = load double, ptr %2, align 8
  %.821.i = fsub double %.820.i, %.97.i
  %.10.i1.i = fmul double %.698.i, %.821.i
  %.11.i2.i = fmul double %.704.i, %.971.i
  %.12.i.i = fadd double %.11.i2.i, %.10.i1.i
  %.13.i.i = fmul double %.701.i, %.896.i
  %.14.i.i = fadd double %.13.i.i, %.12.i.i
  %.1032.i = fdiv double %.14.i.i, %sqrt.i.i
  %.815.i56 = mul i64 %.56, %arg.triangles.5.2
  %3 = getelementptr double, ptr %arg.triangles.4, i64 %.815.i56
  %4 = getelementptr double, ptr %3, i64 %.813.i
  %.969.i57 = getelementptr i8, ptr %4, i64 16
  %.970.i58 = load double, ptr %.969.i57, align 8
  %.971.i59 = fsub double %.970.i58, %.245.i
  %.894.i60 = getelementptr i8, ptr %4, i64 8
  %.895.i61 = load double, ptr %.894.i60, align 8
  %.896.i62 = fsub double %.895.i61, %.171.i
  %.820.i63 = load double, ptr %4, align 8
  %.821.i64 = fsub double %.820.i63, %.97.i
  %.10.i1.i65 = fmul double %.698.i, %.821.i64
  %.11.i2.i66 = fmul double %.704.i, %.971.i59
  %.12.i.i67 = fadd double %.11.i2.i66, %.10.i1.i65
  %.13.i.i68 = fmul double %.701.i, %.896.i62
  %.14.i.i69 = fadd double %.13.i.i68, %.12.i.i67
  %.1032.i70 = fdiv double %.14.i.i69, %sqrt.i.i
  br label %B0.endif.endif.endif.endif

B0.endif.endif.endif.endif:                       ; preds = %B434.endif.endif.i47, %B0.else.if
  %"$phi482.0.2.0.i87" = phi double [ %.1032.i, %B434.endif.endif.i47 ], [ 0.000000e+00, %B0.else.if ]
  %"$phi482.0.2.0.i46" = phi double [ %.1032.i70, %B434.endif.endif.i47 ], [ 0.000000e+00, %B0.else.if ]
  %.10.i72 = fcmp olt double %"$phi482.0.2.0.i46", %"$phi482.0.2.0.i87"
  %.11.i73 = select i1 %.10.i72, double %"$phi482.0.2.0.i46", double %"$phi482.0.2.0.i87"
  %.189 = fneg double %arg.least
  %.190 = fcmp olt double %.11.i73, %.189
  br i1 %.190, label %B134.endif, label %common.ret

B134.endif:                                       ; preds = %B0.endif.endif.endif.endif
  %.10.i = fcmp ogt double %"$phi482.0.2.0.i46", %"$phi482.0.2.0.i87"
  %.11.i = select i1 %.10.i, double %"$phi482.0.2.0.i46", double %"$phi482.0.2.0.i87"
  %.227 = fcmp ogt double %.11.i, %arg.least
  br i1 %.227, label %B368.endif.endif.2, label %common.ret

B368.endif.endif.2:                               ; preds = %B134.endif
  %.287 = icmp slt i64 %arg.row, 0
  %.288 = select i1 %.287, i64 %arg.triangles.5.0, i64 0
  %.289 = add i64 %.288, %arg.row
  %.319 = mul i64 %.289, %.88.i
  %.321 = mul i64 %arg.k.fr, %arg.triangles.5.2
  %5 = getelementptr double, ptr %arg.triangles.4, i64 %.321
  %.325 = getelementptr double, ptr %5, i64 %.319
  %.326 = load double, ptr %.325, align 8
  %.402 = getelementptr i8, ptr %.325, i64 8
  %.403 = load double, ptr %.402, align 8
  %.481 = getelementptr i8, ptr %.325, i64 16
  %.482 = load double, ptr %.481, align 8
  %.563 = mul i64 %.56, %arg.triangles.5.2
  %6 = getelementptr double, ptr %arg.triangles.4, i64 %.563
  %.567 = getelementptr double, ptr %6, i64 %.319
  %.568 = load double, ptr %.567, align 8
  %.570 = fsub double %.568, %.326
  %.646 = getelementptr i8, ptr %.567, i64 8
  %.647 = load double, ptr %.646, align 8
  %.649 = fsub double %.647, %.403
  %.729 = getelementptr i8, ptr %.567, i64 16
  %.730 = load double, ptr %.729, align 8
  %.732 = fsub double %.730, %.482
  %.983 = fsub double %.97.i, %.326
  %.1061 = fsub double %.171.i, %.403
  %.1139 = fsub double %.245.i, %.482
  %.1217 = fsub double %.319.i, %.326
  %.1295 = fsub double %.394.i, %.403
  %.1373 = fsub double %.469.i, %.482
  %.1375 = fmul double %.1061, %.1373
  %.1376 = fmul double %.1295, %.1139
  %.1377 = fsub double %.1375, %.1376
  %.1378 = fmul double %.1217, %.1139
  %.1379 = fmul double %.983, %.1373
  %.1380 = fsub double %.1378, %.1379
  %.1381 = fmul double %.983, %.1295
  %.1382 = fmul double %.1217, %.1061
  %.1383 = fsub double %.1381, %.1382
  %.10.i74 = fmul double %.570, %.1377
  %.11.i75 = fmul double %.1383, %.732
  %.12.i = fadd double %.10.i74, %.11.i75
  %.13.i = fmul double %.649, %.1380
  %.14.i = fadd double %.13.i, %.12.i
  %.1217.1 = fsub double %.544.i, %.326
  %.1295.1 = fsub double %.619.i, %.403
  %.1373.1 = fsub double %.694.i, %.482
  %.1375.1 = fmul double %.1295, %.1373.1
  %.1376.1 = fmul double %.1295.1, %.1373
  %.1377.1 = fsub double %.1375.1, %.1376.1
  %.1378.1 = fmul double %.1217.1, %.1373
  %.1379.1 = fmul double %.1217, %.1373.1
  %.1380.1 = fsub double %.1378.1, %.1379.1
  %.1381.1 = fmul double %.1217, %.1295.1
  %.1382.1 = fmul double %.1217.1, %.1295
  %.1383.1 = fsub double %.1381.1, %.1382.1
  %.10.i76 = fmul double %.570, %.1377.1
  %.11.i77 = fmul double %.1383.1, %.732
  %.12.i78 = fadd double %.10.i76, %.11.i77
  %.13.i79 = fmul double %.649, %.1380.1
  %.14.i80 = fadd double %.13.i79, %.12.i78
  %.1375.2 = fmul double %.1295.1, %.1139
  %.1376.2 = fmul double %.1061, %.1373.1
  %.1377.2 = fsub double %.1375.2, %.1376.2
  %.1378.2 = fmul double %.983, %.1373.1
  %.1379.2 = fmul double %.1217.1, %.1139
  %.1380.2 = fsub double %.1378.2, %.1379.2
  %.1381.2 = fmul double %.1217.1, %.1061
  %.1382.2 = fmul double %.983, %.1295.1
  %.1383.2 = fsub double %.1381.2, %.1382.2
  %.10.i81 = fmul double %.570, %.1377.2
  %.11.i82 = fmul double %.1383.2, %.732
  %.12.i83 = fadd double %.10.i81, %.11.i82
  %.13.i84 = fmul double %.649, %.1380.2
  %.14.i85 = fadd double %.13.i84, %.12.i83
  %.1420 = fcmp ole double %.14.i, 0.000000e+00
  %.1423 = zext i1 %.1420 to i64
  %.1420.1 = fcmp ole double %.14.i80, 0.000000e+00
  %.1423.1 = zext i1 %.1420.1 to i64
  %.1424.1 = add nuw nsw i64 %.1423.1, %.1423
  %.1412 = fcmp oge double %.14.i, 0.000000e+00
  %.1415 = zext i1 %.1412 to i64
  %.1412.1 = fcmp oge double %.14.i80, 0.000000e+00
  %.1415.1 = zext i1 %.1412.1 to i64
  %.1416.1 = add nuw nsw i64 %.1415.1, %.1415
  %.1412.2 = fcmp oge double %.14.i85, 0.000000e+00
  %.1415.2 = zext i1 %.1412.2 to i64
  %.1416.2 = add nuw nsw i64 %.1416.1, %.1415.2
  %.1420.2 = fcmp ole double %.14.i85, 0.000000e+00
  %.1423.2 = zext i1 %.1420.2 to i64
  %.1424.2 = add nuw nsw i64 %.1424.1, %.1423.2
  %.1449 = icmp eq i64 %.1416.2, 3
  %.1457 = icmp eq i64 %.1424.2, 3
  %spec.select = select i1 %.1449, i1 true, i1 %.1457
  %.1468 = zext i1 %spec.select to i8
  br label %common.ret
}

declare double @llvm.sqrt.f64(double)

define i64 @msf_jax.host.solid.kernels.crossed(ptr readonly %words) local_unnamed_addr {
  %.1242.i = alloca i8, align 1
  %.1290.i = alloca i8, align 1
  %.1489.i = alloca i8, align 1
  %.1543.i = alloca i8, align 1
  %w0 = load ptr, ptr %words, align 8
  %p1 = getelementptr i8, ptr %words, i64 8
  %w1 = load i64, ptr %p1, align 8
  %p7 = getelementptr i8, ptr %words, i64 56
  %w7 = load ptr, ptr %p7, align 8
  %p8 = getelementptr i8, ptr %words, i64 64
  %w8 = load i64, ptr %p8, align 8
  %p9 = getelementptr i8, ptr %words, i64 72
  %w9 = load i64, ptr %p9, align 8
  %p10 = getelementptr i8, ptr %words, i64 80
  %w10 = load i64, ptr %p10, align 8
  %p13 = getelementptr i8, ptr %words, i64 104
  %w13 = load ptr, ptr %p13, align 8
  %p14 = getelementptr i8, ptr %words, i64 112
  %w14 = load i64, ptr %p14, align 8
  %p15 = getelementptr i8, ptr %words, i64 120
  %w15 = load i64, ptr %p15, align 8
  %s24 = shl i64 %w15, 3
  %p16 = getelementptr i8, ptr %words, i64 128
  %w16 = load ptr, ptr %p16, align 8
  %p17 = getelementptr i8, ptr %words, i64 136
  %w17 = load i64, ptr %p17, align 8
  %p18 = getelementptr i8, ptr %words, i64 144
  %w18 = load double, ptr %p18, align 8
  %p19 = getelementptr i8, ptr %words, i64 152
  %w19 = load i64, ptr %p19, align 8
  %p20 = getelementptr i8, ptr %words, i64 160
  %w20 = load ptr, ptr %p20, align 8
  %p22 = getelementptr i8, ptr %words, i64 176
  %w22 = load ptr, ptr %p22, align 8
  %p23 = getelementptr i8, ptr %words, i64 184
  %w23 = load i64, ptr %p23, align 8
  %p24 = getelementptr i8, ptr %words, i64 192
  %w24 = load ptr, ptr %p24, align 8
  %p25 = getelementptr i8, ptr %words, i64 200
  %w25 = load i64, ptr %p25, align 8
  call void @llvm.lifetime.start.p0(ptr nonnull %.1242.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1290.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1489.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1543.i)
  store i64 0, ptr %w20, align 8
  %.276961.not.i = icmp slt i64 %w17, 1
  br i1 %.276961.not.i, label %_ZN7msf_jax4host5solid7kernels7crossedB3v17B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi1E1C7mutable7alignedE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29dx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B134.preheader.i

B134.preheader.i:                                 ; preds = %0
  %1 = shl i64 %w1, 3
  br label %B134.i

B134.i:                                           ; preds = %B900.i, %B134.preheader.i
  %count.5.0968.i = phi i64 [ %count.6.2.i, %B900.i ], [ 0, %B134.preheader.i ]
  %.275911967.i = phi i64 [ %.285.i, %B900.i ], [ %w17, %B134.preheader.i ]
  %.282918966.i = phi i64 [ %.289.i, %B900.i ], [ %w17, %B134.preheader.i ]
  %.285.i = add nsw i64 %.275911967.i, -1
  %.289.i = add i64 %.282918966.i, 1
  %.325.i = sub nsw i64 %.282918966.i, %w17
  %.353.i = getelementptr i64, ptr %w16, i64 %.325.i
  %.354.i = load i64, ptr %.353.i, align 8
  %2 = and i64 %.282918966.i, 1
  %.46.not.not.i.i = icmp eq i64 %2, 0
  br i1 %.46.not.not.i.i, label %B134.endif.i, label %B50.i.i

B50.i.i:                                          ; preds = %B134.i, %B50.i.i
  %node.3.1.i.i = phi i64 [ %.49.i.i, %B50.i.i ], [ %.289.i, %B134.i ]
  %.49.i.i = ashr i64 %node.3.1.i.i, 1
  %3 = and i64 %node.3.1.i.i, 2
  %.55.not.i.i = icmp eq i64 %3, 0
  br i1 %.55.not.i.i, label %B50.i.i, label %B134.endif.i

B208.i:                                           ; preds = %B134.endif.i
  %.436.i = load i64, ptr %w20, align 8
  %.438.i = icmp slt i64 %.436.i, %w19
  br i1 %.438.i, label %B234.preheader.i, label %B900.i

B234.preheader.i:                                 ; preds = %B208.i
  %.477.i = icmp slt i64 %.282918966.i, 0
  %.478.i = select i1 %.477.i, i64 %w14, i64 0
  %.479.i = add i64 %.478.i, %.282918966.i
  %.1002.i = mul nsw i64 %.354.i, 3
  %4 = getelementptr i64, ptr %w0, i64 %.1002.i
  %.1058.i = icmp slt i64 %.354.i, 0
  %.1011.1.3.i = add i64 %.1002.i, 1
  %.1058.3.i = icmp slt i64 %.1011.1.3.i, 0
  %5 = getelementptr i64, ptr %w0, i64 %.1011.1.3.i
  %.1011.1.6.i = add i64 %.1002.i, 2
  %.1058.6.i = icmp slt i64 %.1011.1.6.i, 0
  %6 = getelementptr i64, ptr %w0, i64 %.1011.1.6.i
  %sunkaddr.i = mul i64 %s24, %.479.i
  %sunkaddr109.i = getelementptr i8, ptr %w13, i64 %sunkaddr.i
  %sunkaddr112.i = getelementptr i8, ptr %sunkaddr109.i, i64 8
  %sunkaddr115.i = getelementptr i8, ptr %sunkaddr109.i, i64 16
  %sunkaddr118.i = getelementptr i8, ptr %sunkaddr109.i, i64 24
  %sunkaddr121.i = getelementptr i8, ptr %sunkaddr109.i, i64 40
  %sunkaddr124.i = getelementptr i8, ptr %sunkaddr109.i, i64 32
  %sunkaddr137.i = select i1 %.1058.i, i64 %1, i64 0
  %sunkaddr138.i = getelementptr inbounds i8, ptr %4, i64 %sunkaddr137.i
  %sunkaddr139.i = select i1 %.1058.3.i, i64 %1, i64 0
  %sunkaddr140.i = getelementptr inbounds i8, ptr %5, i64 %sunkaddr139.i
  %sunkaddr141.i = select i1 %.1058.6.i, i64 %1, i64 0
  %sunkaddr142.i = getelementptr inbounds i8, ptr %6, i64 %sunkaddr141.i
  br label %B234.i

B234.i:                                           ; preds = %B874.i, %B234.preheader.i
  %.17953.i = phi i64 [ %.1795.i, %B874.i ], [ %.436.i, %B234.preheader.i ]
  %count.4.1.i = phi i64 [ %count.7.35059.i, %B874.i ], [ %count.5.0968.i, %B234.preheader.i ]
  %node.2.1.i = phi i64 [ %storemerge.i60.i, %B874.i ], [ %node.4.0.i.i, %B234.preheader.i ]
  %.504.i = load double, ptr %sunkaddr109.i, align 8
  %.559.i = load double, ptr %sunkaddr112.i, align 8
  %.614.i = load double, ptr %sunkaddr115.i, align 8
  %.669.i = load double, ptr %sunkaddr118.i, align 8
  %.779.i = load double, ptr %sunkaddr121.i, align 8
  %.87.i.i = mul i64 %node.2.1.i, %w15
  %.91.i.i = getelementptr double, ptr %w13, i64 %.87.i.i
  %.92.i.i = load double, ptr %.91.i.i, align 8
  %.93.i.i = fcmp ogt double %.92.i.i, %.669.i
  br i1 %.93.i.i, label %B30.i.i, label %B32.i.i

B32.i.i:                                          ; preds = %B234.i
  %.724.i = load double, ptr %sunkaddr124.i, align 8
  %sunkaddr.i.i = shl i64 %.87.i.i, 3
  %sunkaddr1.i.i = getelementptr i8, ptr %w13, i64 %sunkaddr.i.i
  %sunkaddr2.i.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 8
  %.152.i.i = load double, ptr %sunkaddr2.i.i, align 8
  %.154.i.i = fcmp ogt double %.152.i.i, %.724.i
  br i1 %.154.i.i, label %B30.i.i, label %B86.i.i

B86.i.i:                                          ; preds = %B32.i.i
  %sunkaddr127.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 16
  %.214.i.i = load double, ptr %sunkaddr127.i, align 8
  %.216.i.i = fcmp ogt double %.214.i.i, %.779.i
  br i1 %.216.i.i, label %B30.i.i, label %B92.i.i

B92.i.i:                                          ; preds = %B86.i.i
  %sunkaddr130.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 24
  %.287.i.i = load double, ptr %sunkaddr130.i, align 8
  %.289.i.i = fcmp olt double %.287.i.i, %.504.i
  br i1 %.289.i.i, label %B30.i.i, label %B120.i.i

B120.i.i:                                         ; preds = %B92.i.i
  %sunkaddr133.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 32
  %.349.i.i = load double, ptr %sunkaddr133.i, align 8
  %.351.i.i = fcmp olt double %.349.i.i, %.559.i
  br i1 %.351.i.i, label %B30.i.i, label %_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i

_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i: ; preds = %B120.i.i
  %sunkaddr136.i = getelementptr i8, ptr %sunkaddr1.i.i, i64 40
  %.413.i.i = load double, ptr %sunkaddr136.i, align 8
  %.417.i.i = fcmp uge double %.413.i.i, %.614.i
  br i1 %.417.i.i, label %B378.i, label %B30.i.i

B378.i:                                           ; preds = %_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i
  %.829.not.i = icmp slt i64 %node.2.1.i, %w17
  br i1 %.829.not.i, label %B836.endif.i, label %B534.i

B534.i:                                           ; preds = %B378.i
  %.837.i = sub nsw i64 %node.2.1.i, %w17
  %.865.i = getelementptr i64, ptr %w16, i64 %.837.i
  %.866.i = load i64, ptr %.865.i, align 8
  %.1074.i = load i64, ptr %sunkaddr138.i, align 8
  %.idx.i = mul i64 %.866.i, 24
  %7 = getelementptr i8, ptr %w0, i64 %.idx.i
  %.1134.i = icmp slt i64 %.866.i, 0
  %.1135.i = select i1 %.1134.i, i64 %w1, i64 0
  %.1149.i = getelementptr i64, ptr %7, i64 %.1135.i
  %.1150.i = load i64, ptr %.1149.i, align 8
  %.1151.not.i = icmp eq i64 %.1074.i, %.1150.i
  br i1 %.1151.not.i, label %B30.i.i, label %B534.1.i

B534.1.i:                                         ; preds = %B534.i
  %8 = getelementptr i8, ptr %7, i64 8
  %.1149.1.i = getelementptr i64, ptr %8, i64 %.1135.i
  %.1150.1.i = load i64, ptr %.1149.1.i, align 8
  %.1151.1.not.i = icmp eq i64 %.1074.i, %.1150.1.i
  br i1 %.1151.1.not.i, label %B30.i.i, label %B534.2.i

B534.2.i:                                         ; preds = %B534.1.i
  %9 = getelementptr i8, ptr %7, i64 16
  %.1149.2.i = getelementptr i64, ptr %9, i64 %.1135.i
  %.1150.2.i = load i64, ptr %.1149.2.i, align 8
  %.1151.2.not.i = icmp eq i64 %.1074.i, %.1150.2.i
  br i1 %.1151.2.not.i, label %B30.i.i, label %B534.3.i

B534.3.i:                                         ; preds = %B534.2.i
  %.1074.3.i = load i64, ptr %sunkaddr140.i, align 8
  %.1151.3.not.i = icmp eq i64 %.1074.3.i, %.1150.i
  %.1151.4.not.i = icmp eq i64 %.1074.3.i, %.1150.1.i
  %or.cond.i = or i1 %.1151.3.not.i, %.1151.4.not.i
  %.1151.5.not.i = icmp eq i64 %.1074.3.i, %.1150.2.i
  %or.cond30.i = or i1 %.1151.5.not.i, %or.cond.i
  br i1 %or.cond30.i, label %B30.i.i, label %B534.6.i

B534.6.i:                                         ; preds = %B534.3.i
  %.1074.6.i = load i64, ptr %sunkaddr142.i, align 8
  %.1151.6.not.i = icmp eq i64 %.1074.6.i, %.1150.i
  %.1151.7.not.i = icmp eq i64 %.1074.6.i, %.1150.1.i
  %or.cond31.i = or i1 %.1151.6.not.i, %.1151.7.not.i
  %.1151.8.not.i = icmp eq i64 %.1074.6.i, %.1150.2.i
  %or.cond32.i = or i1 %.1151.8.not.i, %or.cond31.i
  br i1 %or.cond32.i, label %B30.i.i, label %B542.i

B542.i:                                           ; preds = %B534.6.i
  %.1206.i = add nsw i64 %.17953.i, 1
  store i64 %.1206.i, ptr %w20, align 8
  call fastcc void @_ZN7msf_jax4host5solid7kernels9straddlesB3v19B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi3E1C7mutable7alignedExxd(ptr nonnull %.1242.i, ptr readonly %w7, i64 %w8, i64 %w9, i64 %w10, i64 %.354.i, i64 %.866.i, double %w18)
  %.1262.i = load i8, ptr %.1242.i, align 1
  %.1265.i = icmp eq i8 %.1262.i, 0
  br i1 %.1265.i, label %B30.i.i, label %B542.endif.i

B684.i:                                           ; preds = %B542.endif.i
  call fastcc void @_ZN7msf_jax4host5solid7kernels6passesB3v24B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi3E1C7mutable7alignedExxxd(ptr nonnull %.1489.i, ptr readonly %w7, i64 %w8, i64 %w9, i64 %w10, i64 %.354.i, i64 0, i64 %.866.i, double %w18)
  %.1509.i = load i8, ptr %.1489.i, align 1
  %.1512.i = icmp eq i8 %.1509.i, 0
  br i1 %.1512.i, label %B684.endif.thread.i, label %B760.i

B760.i:                                           ; preds = %B684.endif.thread.i, %B684.i
  %.1607.i = icmp slt i64 %count.4.1.i, %w23
  br i1 %.1607.i, label %B802.i, label %B824.i

B802.i:                                           ; preds = %B760.i
  %.1624.i = icmp slt i64 %count.4.1.i, 0
  %.1625.i = select i1 %.1624.i, i64 %w23, i64 0
  %10 = getelementptr i64, ptr %w22, i64 %count.4.1.i
  %.1639.i = getelementptr i64, ptr %10, i64 %.1625.i
  store i64 %.354.i, ptr %.1639.i, align 8
  %.1657.i = select i1 %.1624.i, i64 %w25, i64 0
  %11 = getelementptr i64, ptr %w24, i64 %count.4.1.i
  %.1671.i = getelementptr i64, ptr %11, i64 %.1657.i
  store i64 %.866.i, ptr %.1671.i, align 8
  br label %B824.i

B824.i:                                           ; preds = %B802.i, %B760.i
  %.1680.i = add nsw i64 %count.4.1.i, 1
  br label %B30.i.i

B722.1.i:                                         ; preds = %B722.endif.thread.i
  call fastcc void @_ZN7msf_jax4host5solid7kernels6passesB3v24B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi3E1C7mutable7alignedExxxd(ptr nonnull %.1543.i, ptr readonly %w7, i64 %w8, i64 %w9, i64 %w10, i64 %.866.i, i64 1, i64 %.354.i, double %w18)
  %.1563.1.i = load i8, ptr %.1543.i, align 1
  %.1566.1.i = icmp eq i8 %.1563.1.i, 0
  br i1 %.1566.1.i, label %B684.2.i, label %B760.1.i

B760.1.i:                                         ; preds = %B722.endif.thread.i, %B722.1.i
  %.1607.1.i = icmp slt i64 %count.4.1.i, %w23
  br i1 %.1607.1.i, label %B802.1.i, label %B824.1.i

B802.1.i:                                         ; preds = %B760.1.i
  %.1624.1.i = icmp slt i64 %count.4.1.i, 0
  %.1625.1.i = select i1 %.1624.1.i, i64 %w23, i64 0
  %12 = getelementptr i64, ptr %w22, i64 %count.4.1.i
  %.1639.1.i = getelementptr i64, ptr %12, i64 %.1625.1.i
  store i64 %.354.i, ptr %.1639.1.i, align 8
  %.1657.1.i = select i1 %.1624.1.i, i64 %w25, i64 0
  %13 = getelementptr i64, ptr %w24, i64 %count.4.1.i
  %.1671.1.i = getelementptr i64, ptr %13, i64 %.1657.1.i
  store i64 %.866.i, ptr %.1671.1.i, align 8
  br label %B824.1.i

B824.1.i:                                         ; preds = %B802.1.i, %B760.1.i
  %.1680.1.i = add nsw i64 %count.4.1.i, 1
  br label %B30.i.i

B684.2.i:                                         ; preds = %B722.1.i
  call fastcc void @_ZN7msf_jax4host5solid7kernels6passesB3v24B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi3E1C7mutable7alignedExxxd(ptr nonnull %.1489.i, ptr readonly %w7, i64 %w8, i64 %w9, i64 %w10, i64 %.354.i, i64 2, i64 %.866.i, double %w18)
  %.1509.2.i = load i8, ptr %.1489.i, align 1
  %.1512.2.i = icmp eq i8 %.1509.2.i, 0
  br i1 %.1512.2.i, label %B722.2.i, label %B760.2.i

B722.2.i:                                         ; preds = %B684.2.i
  call fastcc void @_ZN7msf_jax4host5solid7kernels6passesB3v24B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi3E1C7mutable7alignedExxxd(ptr nonnull %.1543.i, ptr readonly %w7, i64 %w8, i64 %w9, i64 %w10, i64 %.866.i, i64 2, i64 %.354.i, double %w18)
  %.1563.2.i = load i8, ptr %.1543.i, align 1
  %.1566.2.i = icmp eq i8 %.1563.2.i, 0
  br i1 %.1566.2.i, label %B30.i.i, label %B760.2.i

B760.2.i:                                         ; preds = %B722.2.i, %B684.2.i
  %.1607.2.i = icmp slt i64 %count.4.1.i, %w23
  br i1 %.1607.2.i, label %B802.2.i, label %B824.2.i

B802.2.i:                                         ; preds = %B760.2.i
  %.1624.2.i = icmp slt i64 %count.4.1.i, 0
  %.1625.2.i = select i1 %.1624.2.i, i64 %w23, i64 0
  %14 = getelementptr i64, ptr %w22, i64 %count.4.1.i
  %.1639.2.i = getelementptr i64, ptr %14, i64 %.1625.2.i
  store i64 %.354.i, ptr %.1639.2.i, align 8
  %.1657.2.i = select i1 %.1624.2.i, i64 %w25, i64 0
  %15 = getelementptr i64, ptr %w24, i64 %count.4.1.i
  %.1671.2.i = getelementptr i64, ptr %15, i64 %.1657.2.i
  store i64 %.866.i, ptr %.1671.2.i, align 8
  br label %B824.2.i

B824.2.i:                                         ; preds = %B802.2.i, %B760.2.i
  %.1680.2.i = add nsw i64 %count.4.1.i, 1
  br label %B30.i.i

B30.i.i:                                          ; preds = %B542.endif.i, %B824.2.i, %B722.2.i, %B824.1.i, %B824.i, %B542.i, %B534.6.i, %B534.3.i, %B534.2.i, %B534.1.i, %B534.i, %_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i, %B120.i.i, %B92.i.i, %B86.i.i, %B32.i.i, %B234.i
  %count.7.351.i = phi i64 [ %count.4.1.i, %B234.i ], [ %count.4.1.i, %_ZN7msf_jax4host5solid7kernels8overlapsB3v13B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedExdddddd.exit.i ], [ %count.4.1.i, %B86.i.i ], [ %count.4.1.i, %B92.i.i ], [ %count.4.1.i, %B120.i.i ], [ %count.4.1.i, %B32.i.i ], [ %count.4.1.i, %B722.2.i ], [ %count.4.1.i, %B534.2.i ], [ %count.4.1.i, %B534.6.i ], [ %.1680.i, %B824.i ], [ %count.4.1.i, %B534.1.i ], [ %count.4.1.i, %B534.i ], [ %.1680.2.i, %B824.2.i ], [ %count.4.1.i, %B534.3.i ], [ %.1680.1.i, %B824.1.i ], [ %count.4.1.i, %B542.endif.i ], [ %count.4.1.i, %B542.i ]
  %.36.i33.i = add nuw nsw i64 %node.2.1.i, 1
  %16 = and i64 %node.2.1.i, 1
  %.46.not.not.i34.i = icmp eq i64 %16, 0
  br i1 %.46.not.not.i34.i, label %B70.i.i, label %B50.i35.i

B50.i35.i:                                        ; preds = %B30.i.i, %B50.i35.i
  %node.3.1.i36.i = phi i64 [ %.49.i37.i, %B50.i35.i ], [ %.36.i33.i, %B30.i.i ]
  %.49.i37.i = lshr i64 %node.3.1.i36.i, 1
  %17 = and i64 %node.3.1.i36.i, 2
  %.55.not.i38.i = icmp eq i64 %17, 0
  br i1 %.55.not.i38.i, label %B50.i35.i, label %B70.i.i

B70.i.i:                                          ; preds = %B50.i35.i, %B30.i.i
  %node.4.0.i39.i = phi i64 [ %.36.i33.i, %B30.i.i ], [ %.49.i37.i, %B50.i35.i ]
  %.60.i40.i = icmp sgt i64 %node.4.0.i39.i, 1
  br i1 %.60.i40.i, label %B70.i.B874_crit_edge.i, label %B900.i

B70.i.B874_crit_edge.i:                           ; preds = %B70.i.i
  %.1795.pre.i = load i64, ptr %w20, align 8
  br label %B874.i

B874.i:                                           ; preds = %B836.endif.i, %B70.i.B874_crit_edge.i
  %.1795.i = phi i64 [ %.17953.i, %B836.endif.i ], [ %.1795.pre.i, %B70.i.B874_crit_edge.i ]
  %storemerge.i60.i = phi i64 [ %.28.i.i, %B836.endif.i ], [ %node.4.0.i39.i, %B70.i.B874_crit_edge.i ]
  %count.7.35059.i = phi i64 [ %count.4.1.i, %B836.endif.i ], [ %count.7.351.i, %B70.i.B874_crit_edge.i ]
  %.1797.i = icmp slt i64 %.1795.i, %w19
  br i1 %.1797.i, label %B234.i, label %B900.i

B900.i:                                           ; preds = %B874.i, %B70.i.i, %B134.endif.i, %B208.i
  %count.6.2.i = phi i64 [ %count.5.0968.i, %B208.i ], [ %count.5.0968.i, %B134.endif.i ], [ %count.7.35059.i, %B874.i ], [ %count.7.351.i, %B70.i.i ]
  %.276.i = icmp sgt i64 %.275911967.i, 1
  br i1 %.276.i, label %B134.i, label %_ZN7msf_jax4host5solid7kernels7crossedB3v17B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi1E1C7mutable7alignedE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29dx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit

B134.endif.i:                                     ; preds = %B50.i.i, %B134.i
  %node.4.0.i.i = phi i64 [ %.289.i, %B134.i ], [ %.49.i.i, %B50.i.i ]
  %.60.i.i = icmp slt i64 %node.4.0.i.i, 2
  br i1 %.60.i.i, label %B900.i, label %B208.i

B542.endif.i:                                     ; preds = %B542.i
  call fastcc void @_ZN7msf_jax4host5solid7kernels9straddlesB3v19B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi3E1C7mutable7alignedExxd(ptr nonnull %.1290.i, ptr readonly %w7, i64 %w8, i64 %w9, i64 %w10, i64 %.866.i, i64 %.354.i, double %w18)
  %.1310.i = load i8, ptr %.1290.i, align 1
  %.1313.not.i = icmp eq i8 %.1310.i, 0
  br i1 %.1313.not.i, label %B30.i.i, label %B684.i

B684.endif.thread.i:                              ; preds = %B684.i
  call fastcc void @_ZN7msf_jax4host5solid7kernels6passesB3v24B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi3E1C7mutable7alignedExxxd(ptr nonnull %.1543.i, ptr readonly %w7, i64 %w8, i64 %w9, i64 %w10, i64 %.866.i, i64 0, i64 %.354.i, double %w18)
  %.1563.i = load i8, ptr %.1543.i, align 1
  %.1566.i = icmp eq i8 %.1563.i, 0
  br i1 %.1566.i, label %B722.endif.thread.i, label %B760.i

B722.endif.thread.i:                              ; preds = %B684.endif.thread.i
  call fastcc void @_ZN7msf_jax4host5solid7kernels6passesB3v24B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi3E1C7mutable7alignedExxxd(ptr nonnull %.1489.i, ptr readonly %w7, i64 %w8, i64 %w9, i64 %w10, i64 %.354.i, i64 1, i64 %.866.i, double %w18)
  %.1509.1.i = load i8, ptr %.1489.i, align 1
  %.1512.1.i = icmp eq i8 %.1509.1.i, 0
  br i1 %.1512.1.i, label %B722.1.i, label %B760.1.i

B836.endif.i:                                     ; preds = %B378.i
  %.28.i.i = shl nuw nsw i64 %node.2.1.i, 1
  br label %B874.i

_ZN7msf_jax4host5solid7kernels7crossedB3v17B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi1E1C7mutable7alignedE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29dx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B900.i, %0
  %count.5.0.lcssa.i = phi i64 [ 0, %0 ], [ %count.6.2.i, %B900.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.1242.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.1290.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.1489.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.1543.i)
  ret i64 %count.5.0.lcssa.i
}

declare { i64, i1 } @llvm.usub.with.overflow.i64(i64, i64)

define i64 @msf_jax.host.solid.loops.loops(ptr readonly %words) local_unnamed_addr {
  %w0 = load ptr, ptr %words, align 8
  %p1 = getelementptr i8, ptr %words, i64 8
  %w1 = load i64, ptr %p1, align 8
  %p2 = getelementptr i8, ptr %words, i64 16
  %w2 = load i64, ptr %p2, align 8
  %p3 = getelementptr i8, ptr %words, i64 24
  %w3 = load ptr, ptr %p3, align 8
  %p5 = getelementptr i8, ptr %words, i64 40
  %w5 = load i64, ptr %p5, align 8
  %p6 = getelementptr i8, ptr %words, i64 48
  %w6 = load ptr, ptr %p6, align 8
  %p8 = getelementptr i8, ptr %words, i64 64
  %w8 = load ptr, ptr %p8, align 8
  %p10 = getelementptr i8, ptr %words, i64 80
  %w10 = load ptr, ptr %p10, align 8
  %p11 = getelementptr i8, ptr %words, i64 88
  %w11 = load i64, ptr %p11, align 8
  %p12 = getelementptr i8, ptr %words, i64 96
  %w12 = load i64, ptr %p12, align 8
  %p13 = getelementptr i8, ptr %words, i64 104
  %w13 = load ptr, ptr %p13, align 8
  %p14 = getelementptr i8, ptr %words, i64 112
  %w14 = load i64, ptr %p14, align 8
  %p19 = getelementptr i8, ptr %words, i64 152
  %w19 = load ptr, ptr %p19, align 8
  %p20 = getelementptr i8, ptr %words, i64 160
  %w20 = load i64, ptr %p20, align 8
  %p21 = getelementptr i8, ptr %words, i64 168
  %w21 = load ptr, ptr %p21, align 8
  %p22 = getelementptr i8, ptr %words, i64 176
  %w22 = load i64, ptr %p22, align 8
  %p23 = getelementptr i8, ptr %words, i64 184
  %w23 = load i64, ptr %p23, align 8
  %p24 = getelementptr i8, ptr %words, i64 192
  %w24 = load ptr, ptr %p24, align 8
  %p25 = getelementptr i8, ptr %words, i64 200
  %w25 = load i64, ptr %p25, align 8
  %p26 = getelementptr i8, ptr %words, i64 208
  %w26 = load i64, ptr %p26, align 8
  %p27 = getelementptr i8, ptr %words, i64 216
  %w27 = load i64, ptr %p27, align 8
  %p28 = getelementptr i8, ptr %words, i64 224
  %w28 = load ptr, ptr %p28, align 8
  %p30 = getelementptr i8, ptr %words, i64 240
  %w30 = load i64, ptr %p30, align 8
  %p31 = getelementptr i8, ptr %words, i64 248
  %w31 = load ptr, ptr %p31, align 8
  %p33 = getelementptr i8, ptr %words, i64 264
  %w33 = load ptr, ptr %p33, align 8
  %p34 = getelementptr i8, ptr %words, i64 272
  %w34 = load i64, ptr %p34, align 8
  %p35 = getelementptr i8, ptr %words, i64 280
  %w35 = load ptr, ptr %p35, align 8
  %.2941365.not.i = icmp slt i64 %w1, 1
  br i1 %.2941365.not.i, label %_ZN7msf_jax4host5solid5loops5loopsB3v26B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B108.preheader.i

B108.preheader.i:                                 ; preds = %0
  %p36 = getelementptr i8, ptr %words, i64 288
  %w36 = load i64, ptr %p36, align 8
  %1 = icmp slt i64 %w26, 1
  %.1086.i.i = getelementptr i8, ptr %w28, i64 8
  %.1200.i.i = getelementptr i8, ptr %w28, i64 16
  %.1264.i.i = getelementptr double, ptr %w28, i64 %w30
  %.1373.i.i = getelementptr i8, ptr %.1264.i.i, i64 8
  %.1482.i.i = getelementptr i8, ptr %.1264.i.i, i64 16
  %2 = shl i64 %w34, 3
  %3 = shl i64 %w36, 3
  %.720.i = shl i64 %w2, 3
  %.257.i23.i.i = shl i64 %w5, 3
  br label %B108.i

B108.i:                                           ; preds = %B1094.i, %B108.preheader.i
  %count.3.01371.i = phi i64 [ %count.4.2.i, %B1094.i ], [ 0, %B108.preheader.i ]
  %.30013411368.i = phi i64 [ %.307.i, %B1094.i ], [ 0, %B108.preheader.i ]
  %.307.i = add nuw nsw i64 %.30013411368.i, 1
  %4 = getelementptr double, ptr %w6, i64 %.30013411368.i
  %.365.i = load double, ptr %4, align 8
  %5 = getelementptr i64, ptr %w8, i64 %.30013411368.i
  %.402.i = load i64, ptr %5, align 8
  %.403.i = icmp sgt i64 %.402.i, -1
  br i1 %.403.i, label %B154.i, label %B204.endif.i

B154.i:                                           ; preds = %B108.i
  %.203.i17.i.i.i = mul i64 %.30013411368.i, %w2
  %.207.i18.i.i.i = getelementptr double, ptr %w0, i64 %.203.i17.i.i.i
  %.208.i19.i.i.i = load double, ptr %.207.i18.i.i.i, align 8
  %.257.i23.i.i.i = mul i64 %.30013411368.i, %w5
  %.261.i24.i.i.i = getelementptr double, ptr %w3, i64 %.257.i23.i.i.i
  %.262.i25.i.i.i = load double, ptr %.261.i24.i.i.i, align 8
  %.369.i29.i.i.i = getelementptr i8, ptr %.207.i18.i.i.i, i64 8
  %.370.i30.i.i.i = load double, ptr %.369.i29.i.i.i, align 8
  %.423.i32.i.i.i = getelementptr i8, ptr %.261.i24.i.i.i, i64 8
  %.424.i33.i.i.i = load double, ptr %.423.i32.i.i.i, align 8
  %.532.i38.i.i.i = getelementptr i8, ptr %.207.i18.i.i.i, i64 16
  %.533.i39.i.i.i = load double, ptr %.532.i38.i.i.i, align 8
  %.586.i41.i.i.i = getelementptr i8, ptr %.261.i24.i.i.i, i64 16
  %.587.i42.i.i.i = load double, ptr %.586.i41.i.i.i, align 8
  br label %B46.i.i

B46.i.i:                                          ; preds = %B148.endif.2.i.i, %B154.i
  %lsr.iv1.i.i = phi i64 [ %lsr.iv.next2.i.i, %B148.endif.2.i.i ], [ 32, %B154.i ]
  %face.2.0486.i.i = phi i64 [ %.674.1.i.i, %B148.endif.2.i.i ], [ %.402.i, %B154.i ]
  %.237.i.i.i = mul nsw i64 %face.2.0486.i.i, 3
  %.252.peel.i.i.i = icmp slt i64 %face.2.0486.i.i, 0
  %.253.peel.i.i.i = select i1 %.252.peel.i.i.i, i64 %w14, i64 0
  %6 = getelementptr i64, ptr %w13, i64 %.237.i.i.i
  %.267.peel.i.i.i = getelementptr i64, ptr %6, i64 %.253.peel.i.i.i
  %.268.peel.i.i.i = load i64, ptr %.267.peel.i.i.i, align 8
  %.128.i8.peel.i.i.i = icmp slt i64 %.268.peel.i.i.i, 0
  %.129.i9.peel.i.i.i = select i1 %.128.i8.peel.i.i.i, i64 %w11, i64 0
  %.130.i10.peel.i.i.i = add i64 %.129.i9.peel.i.i.i, %.268.peel.i.i.i
  %.150.i11.peel.i.i.i = mul i64 %.130.i10.peel.i.i.i, %w12
  %.154.i12.peel.i.i.i = getelementptr double, ptr %w10, i64 %.150.i11.peel.i.i.i
  %.155.i13.peel.i.i.i = load double, ptr %.154.i12.peel.i.i.i, align 8
  %.209.i20.peel.i.i.i = fsub double %.155.i13.peel.i.i.i, %.208.i19.i.i.i
  %.263.i26.peel.i.i.i = fmul double %.262.i25.i.i.i, %.209.i20.peel.i.i.i
  %.316.i27.peel.i.i.i = getelementptr i8, ptr %.154.i12.peel.i.i.i, i64 8
  %.317.i28.peel.i.i.i = load double, ptr %.316.i27.peel.i.i.i, align 8
  %.371.i31.peel.i.i.i = fsub double %.317.i28.peel.i.i.i, %.370.i30.i.i.i
  %.425.i34.peel.i.i.i = fmul double %.424.i33.i.i.i, %.371.i31.peel.i.i.i
  %.426.i35.peel.i.i.i = fadd double %.263.i26.peel.i.i.i, %.425.i34.peel.i.i.i
  %.479.i36.peel.i.i.i = getelementptr i8, ptr %.154.i12.peel.i.i.i, i64 16
  %.480.i37.peel.i.i.i = load double, ptr %.479.i36.peel.i.i.i, align 8
  %.534.i40.peel.i.i.i = fsub double %.480.i37.peel.i.i.i, %.533.i39.i.i.i
  %.588.i43.peel.i.i.i = fmul double %.587.i42.i.i.i, %.534.i40.peel.i.i.i
  %.589.i44.peel.i.i.i = fadd double %.426.i35.peel.i.i.i, %.588.i43.peel.i.i.i
  %.406.peel.i.i.i = fcmp ult double %.589.i44.peel.i.i.i, 0.000000e+00
  %.pre.i.i.i = add nsw i64 %.237.i.i.i, 1
  %.phi.trans.insert.i.i.i = getelementptr i64, ptr %w13, i64 %.pre.i.i.i
  %.267.peel54.phi.trans.insert.i.i.i = getelementptr i64, ptr %.phi.trans.insert.i.i.i, i64 %.253.peel.i.i.i
  %.268.peel55.pre.i.i.i = load i64, ptr %.267.peel54.phi.trans.insert.i.i.i, align 8
  br i1 %.406.peel.i.i.i, label %B36.endif.endif.backedge.peel.i.i.i, label %B176.endif.peel.i.i.i

B176.endif.peel.i.i.i:                            ; preds = %B46.i.i
  %.128.i.peel.i.i.i = icmp slt i64 %.268.peel55.pre.i.i.i, 0
  %.129.i.peel.i.i.i = select i1 %.128.i.peel.i.i.i, i64 %w11, i64 0
  %.130.i.peel.i.i.i = add i64 %.129.i.peel.i.i.i, %.268.peel55.pre.i.i.i
  %.150.i.peel.i.i.i = mul i64 %.130.i.peel.i.i.i, %w12
  %.154.i.peel.i.i.i = getelementptr double, ptr %w10, i64 %.150.i.peel.i.i.i
  %.155.i.peel.i.i.i = load double, ptr %.154.i.peel.i.i.i, align 8
  %.209.i.peel.i.i.i = fsub double %.155.i.peel.i.i.i, %.208.i19.i.i.i
  %.263.i.peel.i.i.i = fmul double %.262.i25.i.i.i, %.209.i.peel.i.i.i
  %.316.i.peel.i.i.i = getelementptr i8, ptr %.154.i.peel.i.i.i, i64 8
  %.317.i.peel.i.i.i = load double, ptr %.316.i.peel.i.i.i, align 8
  %.371.i.peel.i.i.i = fsub double %.317.i.peel.i.i.i, %.370.i30.i.i.i
  %.425.i.peel.i.i.i = fmul double %.424.i33.i.i.i, %.371.i.peel.i.i.i
  %.426.i.peel.i.i.i = fadd double %.263.i.peel.i.i.i, %.425.i.peel.i.i.i
  %.479.i.peel.i.i.i = getelementptr i8, ptr %.154.i.peel.i.i.i, i64 16
  %.480.i.peel.i.i.i = load double, ptr %.479.i.peel.i.i.i, align 8
  %.534.i.peel.i.i.i = fsub double %.480.i.peel.i.i.i, %.533.i39.i.i.i
  %.588.i.peel.i.i.i = fmul double %.587.i42.i.i.i, %.534.i.peel.i.i.i
  %.589.i.peel.i.i.i = fadd double %.426.i.peel.i.i.i, %.588.i.peel.i.i.i
  %.473.peel.i.i.i = fcmp olt double %.589.i.peel.i.i.i, 0.000000e+00
  br i1 %.473.peel.i.i.i, label %B46.endif.i.i, label %B36.endif.endif.backedge.peel.i.i.i

B36.endif.endif.backedge.peel.i.i.i:              ; preds = %B46.i.i, %B176.endif.peel.i.i.i
  %.128.i8.peel56.i.i.i = icmp slt i64 %.268.peel55.pre.i.i.i, 0
  %.129.i9.peel57.i.i.i = select i1 %.128.i8.peel56.i.i.i, i64 %w11, i64 0
  %.130.i10.peel58.i.i.i = add i64 %.129.i9.peel57.i.i.i, %.268.peel55.pre.i.i.i
  %.150.i11.peel59.i.i.i = mul i64 %.130.i10.peel58.i.i.i, %w12
  %.154.i12.peel60.i.i.i = getelementptr double, ptr %w10, i64 %.150.i11.peel59.i.i.i
  %.155.i13.peel61.i.i.i = load double, ptr %.154.i12.peel60.i.i.i, align 8
  %.209.i20.peel62.i.i.i = fsub double %.155.i13.peel61.i.i.i, %.208.i19.i.i.i
  %.263.i26.peel63.i.i.i = fmul double %.262.i25.i.i.i, %.209.i20.peel62.i.i.i
  %.316.i27.peel64.i.i.i = getelementptr i8, ptr %.154.i12.peel60.i.i.i, i64 8
  %.317.i28.peel65.i.i.i = load double, ptr %.316.i27.peel64.i.i.i, align 8
  %.371.i31.peel66.i.i.i = fsub double %.317.i28.peel65.i.i.i, %.370.i30.i.i.i
  %.425.i34.peel67.i.i.i = fmul double %.424.i33.i.i.i, %.371.i31.peel66.i.i.i
  %.426.i35.peel68.i.i.i = fadd double %.263.i26.peel63.i.i.i, %.425.i34.peel67.i.i.i
  %.479.i36.peel69.i.i.i = getelementptr i8, ptr %.154.i12.peel60.i.i.i, i64 16
  %.480.i37.peel70.i.i.i = load double, ptr %.479.i36.peel69.i.i.i, align 8
  %.534.i40.peel71.i.i.i = fsub double %.480.i37.peel70.i.i.i, %.533.i39.i.i.i
  %.588.i43.peel72.i.i.i = fmul double %.587.i42.i.i.i, %.534.i40.peel71.i.i.i
  %.589.i44.peel73.i.i.i = fadd double %.426.i35.peel68.i.i.i, %.588.i43.peel72.i.i.i
  %.406.peel74.i.i.i = fcmp ult double %.589.i44.peel73.i.i.i, 0.000000e+00
  %.pre161.i.i.i = add nsw i64 %.237.i.i.i, 2
  %.phi.trans.insert2.i.i.i = getelementptr i64, ptr %w13, i64 %.pre161.i.i.i
  %.267.peel110.phi.trans.insert.i.i.i = getelementptr i64, ptr %.phi.trans.insert2.i.i.i, i64 %.253.peel.i.i.i
  %.268.peel111.pre.i.i.i = load i64, ptr %.267.peel110.phi.trans.insert.i.i.i, align 8
  br i1 %.406.peel74.i.i.i, label %B36.endif.endif.backedge.peel103.i.i.i, label %B176.endif.peel75.i.i.i

B176.endif.peel75.i.i.i:                          ; preds = %B36.endif.endif.backedge.peel.i.i.i
  %.128.i.peel82.i.i.i = icmp slt i64 %.268.peel111.pre.i.i.i, 0
  %.129.i.peel83.i.i.i = select i1 %.128.i.peel82.i.i.i, i64 %w11, i64 0
  %.130.i.peel84.i.i.i = add i64 %.129.i.peel83.i.i.i, %.268.peel111.pre.i.i.i
  %.150.i.peel85.i.i.i = mul i64 %.130.i.peel84.i.i.i, %w12
  %.154.i.peel86.i.i.i = getelementptr double, ptr %w10, i64 %.150.i.peel85.i.i.i
  %.155.i.peel87.i.i.i = load double, ptr %.154.i.peel86.i.i.i, align 8
  %.209.i.peel88.i.i.i = fsub double %.155.i.peel87.i.i.i, %.208.i19.i.i.i
  %.263.i.peel89.i.i.i = fmul double %.262.i25.i.i.i, %.209.i.peel88.i.i.i
  %.316.i.peel90.i.i.i = getelementptr i8, ptr %.154.i.peel86.i.i.i, i64 8
  %.317.i.peel91.i.i.i = load double, ptr %.316.i.peel90.i.i.i, align 8
  %.371.i.peel92.i.i.i = fsub double %.317.i.peel91.i.i.i, %.370.i30.i.i.i
  %.425.i.peel93.i.i.i = fmul double %.424.i33.i.i.i, %.371.i.peel92.i.i.i
  %.426.i.peel94.i.i.i = fadd double %.263.i.peel89.i.i.i, %.425.i.peel93.i.i.i
  %.479.i.peel95.i.i.i = getelementptr i8, ptr %.154.i.peel86.i.i.i, i64 16
  %.480.i.peel96.i.i.i = load double, ptr %.479.i.peel95.i.i.i, align 8
  %.534.i.peel97.i.i.i = fsub double %.480.i.peel96.i.i.i, %.533.i39.i.i.i
  %.588.i.peel98.i.i.i = fmul double %.587.i42.i.i.i, %.534.i.peel97.i.i.i
  %.589.i.peel99.i.i.i = fadd double %.426.i.peel94.i.i.i, %.588.i.peel98.i.i.i
  %.473.peel100.i.i.i = fcmp olt double %.589.i.peel99.i.i.i, 0.000000e+00
  br i1 %.473.peel100.i.i.i, label %B46.endif.i.i, label %B36.endif.endif.backedge.peel103.i.i.i

B36.endif.endif.backedge.peel103.i.i.i:           ; preds = %B36.endif.endif.backedge.peel.i.i.i, %B176.endif.peel75.i.i.i
  %.128.i8.peel112.i.i.i = icmp slt i64 %.268.peel111.pre.i.i.i, 0
  %.129.i9.peel113.i.i.i = select i1 %.128.i8.peel112.i.i.i, i64 %w11, i64 0
  %.130.i10.peel114.i.i.i = add i64 %.129.i9.peel113.i.i.i, %.268.peel111.pre.i.i.i
  %.150.i11.peel115.i.i.i = mul i64 %.130.i10.peel114.i.i.i, %w12
  %.154.i12.peel116.i.i.i = getelementptr double, ptr %w10, i64 %.150.i11.peel115.i.i.i
  %.155.i13.peel117.i.i.i = load double, ptr %.154.i12.peel116.i.i.i, align 8
  %.209.i20.peel118.i.i.i = fsub double %.155.i13.peel117.i.i.i, %.208.i19.i.i.i
  %.263.i26.peel119.i.i.i = fmul double %.262.i25.i.i.i, %.209.i20.peel118.i.i.i
  %.316.i27.peel120.i.i.i = getelementptr i8, ptr %.154.i12.peel116.i.i.i, i64 8
  %.317.i28.peel121.i.i.i = load double, ptr %.316.i27.peel120.i.i.i, align 8
  %.371.i31.peel122.i.i.i = fsub double %.317.i28.peel121.i.i.i, %.370.i30.i.i.i
  %.425.i34.peel123.i.i.i = fmul double %.424.i33.i.i.i, %.371.i31.peel122.i.i.i
  %.426.i35.peel124.i.i.i = fadd double %.263.i26.peel119.i.i.i, %.425.i34.peel123.i.i.i
  %.479.i36.peel125.i.i.i = getelementptr i8, ptr %.154.i12.peel116.i.i.i, i64 16
  %.480.i37.peel126.i.i.i = load double, ptr %.479.i36.peel125.i.i.i, align 8
  %.534.i40.peel127.i.i.i = fsub double %.480.i37.peel126.i.i.i, %.533.i39.i.i.i
  %.588.i43.peel128.i.i.i = fmul double %.587.i42.i.i.i, %.534.i40.peel127.i.i.i
  %.589.i44.peel129.i.i.i = fadd double %.426.i35.peel124.i.i.i, %.588.i43.peel128.i.i.i
  %.406.peel130.i.i.i = fcmp oge double %.589.i44.peel129.i.i.i, 0.000000e+00
  %.473.peel156.i.i.i = fcmp olt double %.589.i44.peel.i.i.i, 0.000000e+00
  %or.cond.i.i = and i1 %.473.peel156.i.i.i, %.406.peel130.i.i.i
  br i1 %or.cond.i.i, label %B46.endif.i.i, label %B148.endif.2.i.i

B46.endif.i.i:                                    ; preds = %B36.endif.endif.backedge.peel103.i.i.i, %B176.endif.peel75.i.i.i, %B176.endif.peel.i.i.i
  %storemerge.i.i.i = phi i64 [ %.pre.i.i.i, %B176.endif.peel75.i.i.i ], [ %.237.i.i.i, %B176.endif.peel.i.i.i ], [ %.pre161.i.i.i, %B36.endif.endif.backedge.peel103.i.i.i ]
  %.294.i.i = icmp sgt i64 %storemerge.i.i.i, -1
  br i1 %.294.i.i, label %B204.endif.i, label %B46.endif.B148.endif.2_crit_edge.i.i

B46.endif.B148.endif.2_crit_edge.i.i:             ; preds = %B46.endif.i.i
  %.phi.trans.insert.i2.i = getelementptr i8, ptr %6, i64 16
  %.489.2.phi.trans.insert.i.i = getelementptr i64, ptr %.phi.trans.insert.i2.i, i64 %.253.peel.i.i.i
  %.490.2.pre.i.i = load i64, ptr %.489.2.phi.trans.insert.i.i, align 8
  br label %B148.endif.2.i.i

B148.endif.2.i.i:                                 ; preds = %B46.endif.B148.endif.2_crit_edge.i.i, %B36.endif.endif.backedge.peel103.i.i.i
  %.490.2.i.i = phi i64 [ %.490.2.pre.i.i, %B46.endif.B148.endif.2_crit_edge.i.i ], [ %.268.peel111.pre.i.i.i, %B36.endif.endif.backedge.peel103.i.i.i ]
  %.128.i7.i.i = icmp slt i64 %.268.peel55.pre.i.i.i, 0
  %.129.i8.i.i = select i1 %.128.i7.i.i, i64 %w11, i64 0
  %.130.i9.i.i = add i64 %.129.i8.i.i, %.268.peel55.pre.i.i.i
  %.150.i10.i.i = mul i64 %.130.i9.i.i, %w12
  %.154.i11.i.i = getelementptr double, ptr %w10, i64 %.150.i10.i.i
  %.155.i12.i.i = load double, ptr %.154.i11.i.i, align 8
  %.209.i19.i.i = fsub double %.155.i12.i.i, %.208.i19.i.i.i
  %.263.i25.i.i = fmul double %.262.i25.i.i.i, %.209.i19.i.i
  %.316.i26.i.i = getelementptr i8, ptr %.154.i11.i.i, i64 8
  %.317.i27.i.i = load double, ptr %.316.i26.i.i, align 8
  %.371.i30.i.i = fsub double %.317.i27.i.i, %.370.i30.i.i.i
  %.425.i33.i.i = fmul double %.424.i33.i.i.i, %.371.i30.i.i
  %.426.i34.i.i = fadd double %.263.i25.i.i, %.425.i33.i.i
  %.479.i35.i.i = getelementptr i8, ptr %.154.i11.i.i, i64 16
  %.480.i36.i.i = load double, ptr %.479.i35.i.i, align 8
  %.534.i39.i.i = fsub double %.480.i36.i.i, %.533.i39.i.i.i
  %.588.i42.i.i = fmul double %.587.i42.i.i.i, %.534.i39.i.i
  %.589.i43.i.i = fadd double %.426.i34.i.i, %.588.i42.i.i
  %.128.i44.i.i = icmp slt i64 %.490.2.i.i, 0
  %.129.i45.i.i = select i1 %.128.i44.i.i, i64 %w11, i64 0
  %.130.i46.i.i = add i64 %.129.i45.i.i, %.490.2.i.i
  %.150.i47.i.i = mul i64 %.130.i46.i.i, %w12
  %.154.i48.i.i = getelementptr double, ptr %w10, i64 %.150.i47.i.i
  %.155.i49.i.i = load double, ptr %.154.i48.i.i, align 8
  %.209.i56.i.i = fsub double %.155.i49.i.i, %.208.i19.i.i.i
  %.263.i62.i.i = fmul double %.262.i25.i.i.i, %.209.i56.i.i
  %.316.i63.i.i = getelementptr i8, ptr %.154.i48.i.i, i64 8
  %.317.i64.i.i = load double, ptr %.316.i63.i.i, align 8
  %.371.i67.i.i = fsub double %.317.i64.i.i, %.370.i30.i.i.i
  %.425.i70.i.i = fmul double %.424.i33.i.i.i, %.371.i67.i.i
  %.426.i71.i.i = fadd double %.263.i62.i.i, %.425.i70.i.i
  %.479.i72.i.i = getelementptr i8, ptr %.154.i48.i.i, i64 16
  %.480.i73.i.i = load double, ptr %.479.i72.i.i, align 8
  %.534.i76.i.i = fsub double %.480.i73.i.i, %.533.i39.i.i.i
  %.588.i79.i.i = fmul double %.587.i42.i.i.i, %.534.i76.i.i
  %.589.i80.i.i = fadd double %.426.i71.i.i, %.588.i79.i.i
  %.547.1.i.i = tail call double @llvm.fabs.f64(double %.589.i43.i.i)
  %.547.i.i = tail call double @llvm.fabs.f64(double %.589.i44.peel.i.i.i)
  %.553.i.i = fcmp ogt double %.547.i.i, -1.000000e+00
  %most.3.2.i.i = select i1 %.553.i.i, double %.547.i.i, double -1.000000e+00
  %.553.1.i.i = fcmp ogt double %.547.1.i.i, %most.3.2.i.i
  %most.3.2.1.i.i = select i1 %.553.1.i.i, double %.547.1.i.i, double %most.3.2.i.i
  %.547.2.i.i = tail call double @llvm.fabs.f64(double %.589.i80.i.i)
  %.553.2.i.i = fcmp ogt double %.547.2.i.i, %most.3.2.1.i.i
  %7 = select i1 %.553.1.i.i, i64 2, i64 1
  %.616.i.i = select i1 %.553.2.i.i, i64 0, i64 %7
  %.637.i.i = add nsw i64 %.616.i.i, %.237.i.i.i
  %.650.i.i = icmp slt i64 %.637.i.i, 0
  %.651.i.i = select i1 %.650.i.i, i64 %w20, i64 0
  %8 = getelementptr i64, ptr %w19, i64 %.637.i.i
  %.665.i.i = getelementptr i64, ptr %8, i64 %.651.i.i
  %.666.i.i = load i64, ptr %.665.i.i, align 8
  %.685.i.i = sdiv i64 %.666.i.i, 3
  %.686.i.i = srem i64 %.666.i.i, 3
  %.686.lobit.i.i = ashr i64 %.686.i.i, 63
  %.674.1.i.i = add nsw i64 %.686.lobit.i.i, %.685.i.i
  %lsr.iv.next2.i.i = add nsw i64 %lsr.iv1.i.i, -1
  %.194.i.i = icmp samesign ugt i64 %lsr.iv1.i.i, 3
  br i1 %.194.i.i, label %B46.i.i, label %B204.endif.i

B236.i:                                           ; preds = %B236.lr.ph.i, %B594.i
  %first.3.11326.i = phi i64 [ %first.7.1.i, %B236.lr.ph.i ], [ %first.5.3100.i, %B594.i ]
  %best.5.11325.i = phi double [ %.365.i, %B236.lr.ph.i ], [ %.1211.i, %B594.i ]
  %.59413171323.i = phi i64 [ 0, %B236.lr.ph.i ], [ %.601.i, %B594.i ]
  %.601.i = add nuw nsw i64 %.59413171323.i, 1
  %.627.i = icmp sgt i64 %first.3.11326.i, -1
  br i1 %.627.i, label %B626.preheader.i, label %B266.outer.preheader.i

B266.outer.preheader.i:                           ; preds = %B236.i
  %.725.pre.i = load double, ptr %sunkaddr144.i, align 8
  %.780.pre.i = load double, ptr %sunkaddr147.i, align 8
  %.835.pre.i = load double, ptr %sunkaddr150.i, align 8
  br label %B266.outer.i

B266.outer.i:                                     ; preds = %B70.i.i, %B266.outer.preheader.i
  %.533.i.i.i = phi double [ %.533.i.i33.i, %B70.i.i ], [ %.835.pre.i, %B266.outer.preheader.i ]
  %.370.i.i.i = phi double [ %.370.i.i28.i, %B70.i.i ], [ %.780.pre.i, %B266.outer.preheader.i ]
  %.208.i.i.i = phi double [ %.208.i.i23.i, %B70.i.i ], [ %.725.pre.i, %B266.outer.preheader.i ]
  %.835.i = phi double [ %.83521.i, %B70.i.i ], [ %.835.pre.i, %B266.outer.preheader.i ]
  %.780.i = phi double [ %.78019.i, %B70.i.i ], [ %.780.pre.i, %B266.outer.preheader.i ]
  %.725.i = phi double [ %.72517.i, %B70.i.i ], [ %.725.pre.i, %B266.outer.preheader.i ]
  %best.3.2.ph.i = phi double [ %best.4.398.i, %B70.i.i ], [ %best.5.11325.i, %B266.outer.preheader.i ]
  %first.6.2.ph.i = phi i64 [ %first.5.3100.i, %B70.i.i ], [ -1, %B266.outer.preheader.i ]
  %which.2.2.ph.i = phi i64 [ %which.3.3102.i, %B70.i.i ], [ %w25, %B266.outer.preheader.i ]
  %node.2.2.ph.i = phi i64 [ %node.4.0.i.i, %B70.i.i ], [ 1, %B266.outer.preheader.i ]
  %.840.i = fmul double %best.3.2.ph.i, %best.3.2.ph.i
  %.443.i.i = fmul double %.840.i, 0x3FF0000000001198
  br label %B266.i

B266.i:                                           ; preds = %B20.i.i, %B266.outer.i
  %node.2.2.i = phi i64 [ %.28.i.i, %B20.i.i ], [ %node.2.2.ph.i, %B266.outer.i ]
  %.47.i.i = icmp slt i64 %node.2.2.i, 0
  %.48.i.i = select i1 %.47.i.i, i64 %w22, i64 0
  %.49.i.i = add i64 %.48.i.i, %node.2.2.i
  %.69.i.i = mul i64 %.49.i.i, %w23
  %.73.i.i = getelementptr double, ptr %w21, i64 %.69.i.i
  %.74.i.i = load double, ptr %.73.i.i, align 8
  %.75.i.i = fsub double %.74.i.i, %.725.i
  %.127.i.i = getelementptr i8, ptr %.73.i.i, i64 24
  %.128.i.i = load double, ptr %.127.i.i, align 8
  %.129.i.i = fsub double %.725.i, %.128.i.i
  %.13.i.i.i = fcmp ogt double %.129.i.i, %.75.i.i
  %.14.i.i.i = select i1 %.13.i.i.i, double %.129.i.i, double %.75.i.i
  %.15.i.i.i = fcmp olt double %.14.i.i.i, 0.000000e+00
  %.16.i.i.i = select i1 %.15.i.i.i, double 0.000000e+00, double %.14.i.i.i
  %.213.i.i = getelementptr i8, ptr %.73.i.i, i64 8
  %.214.i.i = load double, ptr %.213.i.i, align 8
  %.215.i.i = fsub double %.214.i.i, %.780.i
  %.267.i.i = getelementptr i8, ptr %.73.i.i, i64 32
  %.268.i.i = load double, ptr %.267.i.i, align 8
  %.269.i.i = fsub double %.780.i, %.268.i.i
  %.13.i1.i.i = fcmp ogt double %.269.i.i, %.215.i.i
  %.14.i2.i.i = select i1 %.13.i1.i.i, double %.269.i.i, double %.215.i.i
  %.15.i3.i.i = fcmp olt double %.14.i2.i.i, 0.000000e+00
  %.16.i4.i.i = select i1 %.15.i3.i.i, double 0.000000e+00, double %.14.i2.i.i
  %.351.i.i = getelementptr i8, ptr %.73.i.i, i64 16
  %.352.i.i = load double, ptr %.351.i.i, align 8
  %.353.i.i = fsub double %.352.i.i, %.835.i
  %.405.i.i = getelementptr i8, ptr %.73.i.i, i64 40
  %.406.i.i = load double, ptr %.405.i.i, align 8
  %.407.i.i = fsub double %.835.i, %.406.i.i
  %.13.i5.i.i = fcmp ogt double %.407.i.i, %.353.i.i
  %.14.i6.i.i = select i1 %.13.i5.i.i, double %.407.i.i, double %.353.i.i
  %.15.i7.i.i = fcmp olt double %.14.i6.i.i, 0.000000e+00
  %.16.i8.i.i = select i1 %.15.i7.i.i, double 0.000000e+00, double %.14.i6.i.i
  %.438.i.i = fmul double %.16.i.i.i, %.16.i.i.i
  %.439.i.i = fmul double %.16.i4.i.i, %.16.i4.i.i
  %.440.i.i = fadd double %.438.i.i, %.439.i.i
  %.441.i.i = fmul double %.16.i8.i.i, %.16.i8.i.i
  %.442.i.i = fadd double %.440.i.i, %.441.i.i
  %.444.i.i = fcmp ugt double %.442.i.i, %.443.i.i
  br i1 %.444.i.i, label %B30.i.i, label %B374.i

B374.i:                                           ; preds = %B266.i
  %.895.not.i = icmp slt i64 %node.2.2.i, %w25
  br i1 %.895.not.i, label %B20.i.i, label %B386.i

B386.i:                                           ; preds = %B374.i
  %.910.i = sub nsw i64 %node.2.2.i, %w25
  %.938.i = getelementptr i64, ptr %w24, i64 %.910.i
  %.939.i = load i64, ptr %.938.i, align 8
  %.237.i.i = mul nsw i64 %.939.i, 3
  %.262.i25.i.i = load double, ptr %sunkaddr152.i, align 8
  %.424.i33.i.i = load double, ptr %sunkaddr155.i, align 8
  %.587.i42.i.i = load double, ptr %sunkaddr158.i, align 8
  %.252.peel.i.i = icmp slt i64 %.939.i, 0
  %.253.peel.i.i = select i1 %.252.peel.i.i, i64 %w14, i64 0
  %9 = getelementptr i64, ptr %w13, i64 %.237.i.i
  %.267.peel.i.i = getelementptr i64, ptr %9, i64 %.253.peel.i.i
  %.268.peel.i.i = load i64, ptr %.267.peel.i.i, align 8
  %.128.i8.peel.i.i = icmp slt i64 %.268.peel.i.i, 0
  %.129.i9.peel.i.i = select i1 %.128.i8.peel.i.i, i64 %w11, i64 0
  %.130.i10.peel.i.i = add i64 %.129.i9.peel.i.i, %.268.peel.i.i
  %.150.i11.peel.i.i = mul i64 %.130.i10.peel.i.i, %w12
  %.154.i12.peel.i.i = getelementptr double, ptr %w10, i64 %.150.i11.peel.i.i
  %.155.i13.peel.i.i = load double, ptr %.154.i12.peel.i.i, align 8
  %.209.i20.peel.i.i = fsub double %.155.i13.peel.i.i, %.725.i
  %.263.i26.peel.i.i = fmul double %.262.i25.i.i, %.209.i20.peel.i.i
  %.316.i27.peel.i.i = getelementptr i8, ptr %.154.i12.peel.i.i, i64 8
  %.317.i28.peel.i.i = load double, ptr %.316.i27.peel.i.i, align 8
  %.371.i31.peel.i.i = fsub double %.317.i28.peel.i.i, %.780.i
  %.425.i34.peel.i.i = fmul double %.424.i33.i.i, %.371.i31.peel.i.i
  %.426.i35.peel.i.i = fadd double %.263.i26.peel.i.i, %.425.i34.peel.i.i
  %.479.i36.peel.i.i = getelementptr i8, ptr %.154.i12.peel.i.i, i64 16
  %.480.i37.peel.i.i = load double, ptr %.479.i36.peel.i.i, align 8
  %.534.i40.peel.i.i = fsub double %.480.i37.peel.i.i, %.835.i
  %.588.i43.peel.i.i = fmul double %.587.i42.i.i, %.534.i40.peel.i.i
  %.589.i44.peel.i.i = fadd double %.426.i35.peel.i.i, %.588.i43.peel.i.i
  %.406.peel.i.i = fcmp ult double %.589.i44.peel.i.i, 0.000000e+00
  %.pre.i.i = add nsw i64 %.237.i.i, 1
  %.phi.trans.insert.i.i = getelementptr i64, ptr %w13, i64 %.pre.i.i
  %.267.peel54.phi.trans.insert.i.i = getelementptr i64, ptr %.phi.trans.insert.i.i, i64 %.253.peel.i.i
  %.268.peel55.pre.i.i = load i64, ptr %.267.peel54.phi.trans.insert.i.i, align 8
  br i1 %.406.peel.i.i, label %B36.endif.endif.backedge.peel.i.i, label %B176.endif.peel.i.i

B176.endif.peel.i.i:                              ; preds = %B386.i
  %.128.i.peel.i.i = icmp slt i64 %.268.peel55.pre.i.i, 0
  %.129.i.peel.i.i = select i1 %.128.i.peel.i.i, i64 %w11, i64 0
  %.130.i.peel.i.i = add i64 %.129.i.peel.i.i, %.268.peel55.pre.i.i
  %.150.i.peel.i.i = mul i64 %.130.i.peel.i.i, %w12
  %.154.i.peel.i.i = getelementptr double, ptr %w10, i64 %.150.i.peel.i.i
  %.155.i.peel.i.i = load double, ptr %.154.i.peel.i.i, align 8
  %.209.i.peel.i.i = fsub double %.155.i.peel.i.i, %.725.i
  %.263.i.peel.i.i = fmul double %.262.i25.i.i, %.209.i.peel.i.i
  %.316.i.peel.i.i = getelementptr i8, ptr %.154.i.peel.i.i, i64 8
  %.317.i.peel.i.i = load double, ptr %.316.i.peel.i.i, align 8
  %.371.i.peel.i.i = fsub double %.317.i.peel.i.i, %.780.i
  %.425.i.peel.i.i = fmul double %.424.i33.i.i, %.371.i.peel.i.i
  %.426.i.peel.i.i = fadd double %.263.i.peel.i.i, %.425.i.peel.i.i
  %.479.i.peel.i.i = getelementptr i8, ptr %.154.i.peel.i.i, i64 16
  %.480.i.peel.i.i = load double, ptr %.479.i.peel.i.i, align 8
  %.534.i.peel.i.i = fsub double %.480.i.peel.i.i, %.835.i
  %.588.i.peel.i.i = fmul double %.587.i42.i.i, %.534.i.peel.i.i
  %.589.i.peel.i.i = fadd double %.426.i.peel.i.i, %.588.i.peel.i.i
  %.473.peel.i.i = fcmp olt double %.589.i.peel.i.i, 0.000000e+00
  br i1 %.473.peel.i.i, label %B386.endif.i, label %B36.endif.endif.backedge.peel.i.i

B36.endif.endif.backedge.peel.i.i:                ; preds = %B386.i, %B176.endif.peel.i.i
  %.128.i8.peel56.i.i = icmp slt i64 %.268.peel55.pre.i.i, 0
  %.129.i9.peel57.i.i = select i1 %.128.i8.peel56.i.i, i64 %w11, i64 0
  %.130.i10.peel58.i.i = add i64 %.129.i9.peel57.i.i, %.268.peel55.pre.i.i
  %.150.i11.peel59.i.i = mul i64 %.130.i10.peel58.i.i, %w12
  %.154.i12.peel60.i.i = getelementptr double, ptr %w10, i64 %.150.i11.peel59.i.i
  %.155.i13.peel61.i.i = load double, ptr %.154.i12.peel60.i.i, align 8
  %.209.i20.peel62.i.i = fsub double %.155.i13.peel61.i.i, %.725.i
  %.263.i26.peel63.i.i = fmul double %.262.i25.i.i, %.209.i20.peel62.i.i
  %.316.i27.peel64.i.i = getelementptr i8, ptr %.154.i12.peel60.i.i, i64 8
  %.317.i28.peel65.i.i = load double, ptr %.316.i27.peel64.i.i, align 8
  %.371.i31.peel66.i.i = fsub double %.317.i28.peel65.i.i, %.780.i
  %.425.i34.peel67.i.i = fmul double %.424.i33.i.i, %.371.i31.peel66.i.i
  %.426.i35.peel68.i.i = fadd double %.263.i26.peel63.i.i, %.425.i34.peel67.i.i
  %.479.i36.peel69.i.i = getelementptr i8, ptr %.154.i12.peel60.i.i, i64 16
  %.480.i37.peel70.i.i = load double, ptr %.479.i36.peel69.i.i, align 8
  %.534.i40.peel71.i.i = fsub double %.480.i37.peel70.i.i, %.835.i
  %.588.i43.peel72.i.i = fmul double %.587.i42.i.i, %.534.i40.peel71.i.i
  %.589.i44.peel73.i.i = fadd double %.426.i35.peel68.i.i, %.588.i43.peel72.i.i
  %.406.peel74.i.i = fcmp ult double %.589.i44.peel73.i.i, 0.000000e+00
  %.pre161.i.i = add nsw i64 %.237.i.i, 2
  %.phi.trans.insert2.i.i = getelementptr i64, ptr %w13, i64 %.pre161.i.i
  %.267.peel110.phi.trans.insert.i.i = getelementptr i64, ptr %.phi.trans.insert2.i.i, i64 %.253.peel.i.i
  %.268.peel111.pre.i.i = load i64, ptr %.267.peel110.phi.trans.insert.i.i, align 8
  br i1 %.406.peel74.i.i, label %B36.endif.endif.backedge.peel103.i.i, label %B176.endif.peel75.i.i

B176.endif.peel75.i.i:                            ; preds = %B36.endif.endif.backedge.peel.i.i
  %.128.i.peel82.i.i = icmp slt i64 %.268.peel111.pre.i.i, 0
  %.129.i.peel83.i.i = select i1 %.128.i.peel82.i.i, i64 %w11, i64 0
  %.130.i.peel84.i.i = add i64 %.129.i.peel83.i.i, %.268.peel111.pre.i.i
  %.150.i.peel85.i.i = mul i64 %.130.i.peel84.i.i, %w12
  %.154.i.peel86.i.i = getelementptr double, ptr %w10, i64 %.150.i.peel85.i.i
  %.155.i.peel87.i.i = load double, ptr %.154.i.peel86.i.i, align 8
  %.209.i.peel88.i.i = fsub double %.155.i.peel87.i.i, %.725.i
  %.263.i.peel89.i.i = fmul double %.262.i25.i.i, %.209.i.peel88.i.i
  %.316.i.peel90.i.i = getelementptr i8, ptr %.154.i.peel86.i.i, i64 8
  %.317.i.peel91.i.i = load double, ptr %.316.i.peel90.i.i, align 8
  %.371.i.peel92.i.i = fsub double %.317.i.peel91.i.i, %.780.i
  %.425.i.peel93.i.i = fmul double %.424.i33.i.i, %.371.i.peel92.i.i
  %.426.i.peel94.i.i = fadd double %.263.i.peel89.i.i, %.425.i.peel93.i.i
  %.479.i.peel95.i.i = getelementptr i8, ptr %.154.i.peel86.i.i, i64 16
  %.480.i.peel96.i.i = load double, ptr %.479.i.peel95.i.i, align 8
  %.534.i.peel97.i.i = fsub double %.480.i.peel96.i.i, %.835.i
  %.588.i.peel98.i.i = fmul double %.587.i42.i.i, %.534.i.peel97.i.i
  %.589.i.peel99.i.i = fadd double %.426.i.peel94.i.i, %.588.i.peel98.i.i
  %.473.peel100.i.i = fcmp olt double %.589.i.peel99.i.i, 0.000000e+00
  br i1 %.473.peel100.i.i, label %B386.endif.i, label %B36.endif.endif.backedge.peel103.i.i

B36.endif.endif.backedge.peel103.i.i:             ; preds = %B36.endif.endif.backedge.peel.i.i, %B176.endif.peel75.i.i
  %.128.i8.peel112.i.i = icmp slt i64 %.268.peel111.pre.i.i, 0
  %.129.i9.peel113.i.i = select i1 %.128.i8.peel112.i.i, i64 %w11, i64 0
  %.130.i10.peel114.i.i = add i64 %.129.i9.peel113.i.i, %.268.peel111.pre.i.i
  %.150.i11.peel115.i.i = mul i64 %.130.i10.peel114.i.i, %w12
  %.154.i12.peel116.i.i = getelementptr double, ptr %w10, i64 %.150.i11.peel115.i.i
  %.155.i13.peel117.i.i = load double, ptr %.154.i12.peel116.i.i, align 8
  %.209.i20.peel118.i.i = fsub double %.155.i13.peel117.i.i, %.725.i
  %.263.i26.peel119.i.i = fmul double %.262.i25.i.i, %.209.i20.peel118.i.i
  %.316.i27.peel120.i.i = getelementptr i8, ptr %.154.i12.peel116.i.i, i64 8
  %.317.i28.peel121.i.i = load double, ptr %.316.i27.peel120.i.i, align 8
  %.371.i31.peel122.i.i = fsub double %.317.i28.peel121.i.i, %.780.i
  %.425.i34.peel123.i.i = fmul double %.424.i33.i.i, %.371.i31.peel122.i.i
  %.426.i35.peel124.i.i = fadd double %.263.i26.peel119.i.i, %.425.i34.peel123.i.i
  %.479.i36.peel125.i.i = getelementptr i8, ptr %.154.i12.peel116.i.i, i64 16
  %.480.i37.peel126.i.i = load double, ptr %.479.i36.peel125.i.i, align 8
  %.534.i40.peel127.i.i = fsub double %.480.i37.peel126.i.i, %.835.i
  %.588.i43.peel128.i.i = fmul double %.587.i42.i.i, %.534.i40.peel127.i.i
  %.589.i44.peel129.i.i = fadd double %.426.i35.peel124.i.i, %.588.i43.peel128.i.i
  %.406.peel130.i.i = fcmp oge double %.589.i44.peel129.i.i, 0.000000e+00
  %.473.peel156.i.i = fcmp olt double %.589.i44.peel.i.i, 0.000000e+00
  %or.cond114.i = and i1 %.473.peel156.i.i, %.406.peel130.i.i
  br i1 %or.cond114.i, label %B386.endif.i, label %B30.i.i

B468.i:                                           ; preds = %B386.endif.i
  %.idx.i.i = mul i64 %.939.i, 24
  %10 = getelementptr i8, ptr %w13, i64 %.idx.i.i
  %.278.i.i = getelementptr i64, ptr %10, i64 %.253.peel.i.i
  %.279.i.i = load i64, ptr %.278.i.i, align 8
  %11 = getelementptr i8, ptr %10, i64 8
  %.353.i5.i = getelementptr i64, ptr %11, i64 %.253.peel.i.i
  %.354.i.i = load i64, ptr %.353.i5.i, align 8
  %.128.i.i.i = icmp slt i64 %.279.i.i, 0
  %.129.i.i.i = select i1 %.128.i.i.i, i64 %w11, i64 0
  %.130.i.i.i = add i64 %.129.i.i.i, %.279.i.i
  %.150.i.i.i = mul i64 %.130.i.i.i, %w12
  %.154.i.i.i = getelementptr double, ptr %w10, i64 %.150.i.i.i
  %.155.i.i.i = load double, ptr %.154.i.i.i, align 8
  %.209.i.i.i = fsub double %.155.i.i.i, %.208.i.i.i
  %.263.i.i.i = fmul double %.262.i25.i.i, %.209.i.i.i
  %.316.i.i.i = getelementptr i8, ptr %.154.i.i.i, i64 8
  %.317.i.i.i = load double, ptr %.316.i.i.i, align 8
  %.371.i.i.i = fsub double %.317.i.i.i, %.370.i.i.i
  %.425.i.i.i = fmul double %.424.i33.i.i, %.371.i.i.i
  %.426.i.i.i = fadd double %.263.i.i.i, %.425.i.i.i
  %.479.i.i.i = getelementptr i8, ptr %.154.i.i.i, i64 16
  %.480.i.i.i = load double, ptr %.479.i.i.i, align 8
  %.534.i.i.i = fsub double %.480.i.i.i, %.533.i.i.i
  %.588.i.i.i = fmul double %.587.i42.i.i, %.534.i.i.i
  %.589.i.i.i = fadd double %.426.i.i.i, %.588.i.i.i
  %.128.i11.i.i = icmp slt i64 %.354.i.i, 0
  %.129.i12.i.i = select i1 %.128.i11.i.i, i64 %w11, i64 0
  %.130.i13.i.i = add i64 %.129.i12.i.i, %.354.i.i
  %.150.i14.i.i = mul i64 %.130.i13.i.i, %w12
  %.154.i15.i.i = getelementptr double, ptr %w10, i64 %.150.i14.i.i
  %.155.i16.i.i = load double, ptr %.154.i15.i.i, align 8
  %.209.i23.i.i = fsub double %.155.i16.i.i, %.208.i.i.i
  %.263.i29.i.i = fmul double %.262.i25.i.i, %.209.i23.i.i
  %.316.i30.i.i = getelementptr i8, ptr %.154.i15.i.i, i64 8
  %.317.i31.i.i = load double, ptr %.316.i30.i.i, align 8
  %.371.i34.i.i = fsub double %.317.i31.i.i, %.370.i.i.i
  %.425.i37.i.i = fmul double %.424.i33.i.i, %.371.i34.i.i
  %.426.i38.i.i = fadd double %.263.i29.i.i, %.425.i37.i.i
  %.479.i39.i.i = getelementptr i8, ptr %.154.i15.i.i, i64 16
  %.480.i40.i.i = load double, ptr %.479.i39.i.i, align 8
  %.534.i43.i.i = fsub double %.480.i40.i.i, %.533.i.i.i
  %.588.i46.i.i = fmul double %.587.i42.i.i, %.534.i43.i.i
  %.589.i47.i.i = fadd double %.426.i38.i.i, %.588.i46.i.i
  %.485.i.i = fcmp oge double %.589.i.i.i, 0.000000e+00
  %.488.i.i = fcmp oge double %.589.i47.i.i, 0.000000e+00
  %.489.i.i = xor i1 %.485.i.i, %.488.i.i
  br i1 %.489.i.i, label %B230.i.i, label %B408.i.i

B230.i.i:                                         ; preds = %B468.i
  %.679.i.i = fsub double %.589.i.i.i, %.589.i47.i.i
  %.684.i.i = fdiv double %.589.i.i.i, %.679.i.i
  %.837.i.i = select i1 %.485.i.i, i64 0, i64 %w30
  %12 = getelementptr double, ptr %w28, i64 %.837.i.i
  %.789.i.i = fsub double %.155.i16.i.i, %.155.i.i.i
  %.790.i.i = fmul double %.789.i.i, %.684.i.i
  %.791.i.i = fadd double %.155.i.i.i, %.790.i.i
  store double %.791.i.i, ptr %12, align 8
  %sunkaddr.i.i = shl i64 %.150.i.i.i, 3
  %sunkaddr77.i.i = getelementptr i8, ptr %w10, i64 %sunkaddr.i.i
  %sunkaddr78.i.i = getelementptr i8, ptr %sunkaddr77.i.i, i64 8
  %.676.1.i.i = load double, ptr %sunkaddr78.i.i, align 8
  %sunkaddr79.i.i = shl i64 %.150.i14.i.i, 3
  %sunkaddr80.i.i = getelementptr i8, ptr %w10, i64 %sunkaddr79.i.i
  %sunkaddr81.i.i = getelementptr i8, ptr %sunkaddr80.i.i, i64 8
  %.736.1.i.i = load double, ptr %sunkaddr81.i.i, align 8
  %.789.1.i.i = fsub double %.736.1.i.i, %.676.1.i.i
  %.790.1.i.i = fmul double %.684.i.i, %.789.1.i.i
  %.791.1.i.i = fadd double %.676.1.i.i, %.790.1.i.i
  %13 = getelementptr i8, ptr %12, i64 8
  store double %.791.1.i.i, ptr %13, align 8
  %sunkaddr84.i.i = getelementptr i8, ptr %sunkaddr77.i.i, i64 16
  %.676.2.i.i = load double, ptr %sunkaddr84.i.i, align 8
  %sunkaddr87.i.i = getelementptr i8, ptr %sunkaddr80.i.i, i64 16
  %.736.2.i.i = load double, ptr %sunkaddr87.i.i, align 8
  %.789.2.i.i = fsub double %.736.2.i.i, %.676.2.i.i
  %.790.2.i.i = fmul double %.684.i.i, %.789.2.i.i
  %.791.2.i.i = fadd double %.676.2.i.i, %.790.2.i.i
  %14 = getelementptr i8, ptr %12, i64 16
  store double %.791.2.i.i, ptr %14, align 8
  %sunkaddr88.i.i = shl i64 %.253.peel.i.i, 3
  %sunkaddr89.i.i = getelementptr inbounds i8, ptr %11, i64 %sunkaddr88.i.i
  %.279.1.pre.i.i = load i64, ptr %sunkaddr89.i.i, align 8
  %.208.i.1.pre.i.i = load double, ptr %sunkaddr144.i, align 8
  %.262.i.1.pre.i.i = load double, ptr %sunkaddr152.i, align 8
  %.370.i.1.pre.i.i = load double, ptr %sunkaddr147.i, align 8
  %.424.i.1.pre.i.i = load double, ptr %sunkaddr155.i, align 8
  %.533.i.1.pre.i.i = load double, ptr %sunkaddr150.i, align 8
  %.587.i.1.pre.i.i = load double, ptr %sunkaddr158.i, align 8
  br label %B408.i.i

B408.i.i:                                         ; preds = %B230.i.i, %B468.i
  %.533.i.i36.i = phi double [ %.533.i.1.pre.i.i, %B230.i.i ], [ %.533.i.i.i, %B468.i ]
  %.370.i.i31.i = phi double [ %.370.i.1.pre.i.i, %B230.i.i ], [ %.370.i.i.i, %B468.i ]
  %.208.i.i26.i = phi double [ %.208.i.1.pre.i.i, %B230.i.i ], [ %.208.i.i.i, %B468.i ]
  %.587.i.1.i.i = phi double [ %.587.i.1.pre.i.i, %B230.i.i ], [ %.587.i42.i.i, %B468.i ]
  %.424.i.1.i.i = phi double [ %.424.i.1.pre.i.i, %B230.i.i ], [ %.424.i33.i.i, %B468.i ]
  %.262.i.1.i.i = phi double [ %.262.i.1.pre.i.i, %B230.i.i ], [ %.262.i25.i.i, %B468.i ]
  %.279.1.i.i = phi i64 [ %.279.1.pre.i.i, %B230.i.i ], [ %.354.i.i, %B468.i ]
  %15 = getelementptr i8, ptr %10, i64 16
  %.353.1.i.i = getelementptr i64, ptr %15, i64 %.253.peel.i.i
  %.354.1.i.i = load i64, ptr %.353.1.i.i, align 8
  %.128.i.1.i.i = icmp slt i64 %.279.1.i.i, 0
  %.129.i.1.i.i = select i1 %.128.i.1.i.i, i64 %w11, i64 0
  %.130.i.1.i.i = add i64 %.129.i.1.i.i, %.279.1.i.i
  %.150.i.1.i.i = mul i64 %.130.i.1.i.i, %w12
  %.154.i.1.i.i = getelementptr double, ptr %w10, i64 %.150.i.1.i.i
  %.155.i.1.i.i = load double, ptr %.154.i.1.i.i, align 8
  %.209.i.1.i.i = fsub double %.155.i.1.i.i, %.208.i.i26.i
  %.263.i.1.i.i = fmul double %.262.i.1.i.i, %.209.i.1.i.i
  %.316.i.1.i.i = getelementptr i8, ptr %.154.i.1.i.i, i64 8
  %.317.i.1.i.i = load double, ptr %.316.i.1.i.i, align 8
  %.371.i.1.i.i = fsub double %.317.i.1.i.i, %.370.i.i31.i
  %.425.i.1.i.i = fmul double %.424.i.1.i.i, %.371.i.1.i.i
  %.426.i.1.i.i = fadd double %.263.i.1.i.i, %.425.i.1.i.i
  %.479.i.1.i.i = getelementptr i8, ptr %.154.i.1.i.i, i64 16
  %.480.i.1.i.i = load double, ptr %.479.i.1.i.i, align 8
  %.534.i.1.i.i = fsub double %.480.i.1.i.i, %.533.i.i36.i
  %.588.i.1.i.i = fmul double %.587.i.1.i.i, %.534.i.1.i.i
  %.589.i.1.i.i = fadd double %.426.i.1.i.i, %.588.i.1.i.i
  %.128.i11.1.i.i = icmp slt i64 %.354.1.i.i, 0
  %.129.i12.1.i.i = select i1 %.128.i11.1.i.i, i64 %w11, i64 0
  %.130.i13.1.i.i = add i64 %.129.i12.1.i.i, %.354.1.i.i
  %.150.i14.1.i.i = mul i64 %.130.i13.1.i.i, %w12
  %.154.i15.1.i.i = getelementptr double, ptr %w10, i64 %.150.i14.1.i.i
  %.155.i16.1.i.i = load double, ptr %.154.i15.1.i.i, align 8
  %.209.i23.1.i.i = fsub double %.155.i16.1.i.i, %.208.i.i26.i
  %.263.i29.1.i.i = fmul double %.262.i.1.i.i, %.209.i23.1.i.i
  %.316.i30.1.i.i = getelementptr i8, ptr %.154.i15.1.i.i, i64 8
  %.317.i31.1.i.i = load double, ptr %.316.i30.1.i.i, align 8
  %.371.i34.1.i.i = fsub double %.317.i31.1.i.i, %.370.i.i31.i
  %.425.i37.1.i.i = fmul double %.424.i.1.i.i, %.371.i34.1.i.i
  %.426.i38.1.i.i = fadd double %.263.i29.1.i.i, %.425.i37.1.i.i
  %.479.i39.1.i.i = getelementptr i8, ptr %.154.i15.1.i.i, i64 16
  %.480.i40.1.i.i = load double, ptr %.479.i39.1.i.i, align 8
  %.534.i43.1.i.i = fsub double %.480.i40.1.i.i, %.533.i.i36.i
  %.588.i46.1.i.i = fmul double %.587.i.1.i.i, %.534.i43.1.i.i
  %.589.i47.1.i.i = fadd double %.426.i38.1.i.i, %.588.i46.1.i.i
  %.485.1.i.i = fcmp oge double %.589.i.1.i.i, 0.000000e+00
  %.488.1.i.i = fcmp oge double %.589.i47.1.i.i, 0.000000e+00
  %.489.1.i.i = xor i1 %.485.1.i.i, %.488.1.i.i
  br i1 %.489.1.i.i, label %B230.1.i.i, label %B408.B408.1_crit_edge.i.i

B408.B408.1_crit_edge.i.i:                        ; preds = %B408.i.i
  %.pre.i6.i = shl i64 %.253.peel.i.i, 3
  br label %B408.1.i.i

B230.1.i.i:                                       ; preds = %B408.i.i
  %.679.1.i.i = fsub double %.589.i.1.i.i, %.589.i47.1.i.i
  %.684.1.i.i = fdiv double %.589.i.1.i.i, %.679.1.i.i
  %.837.1.i.i = select i1 %.485.1.i.i, i64 0, i64 %w30
  %16 = getelementptr double, ptr %w28, i64 %.837.1.i.i
  %.789.154.i.i = fsub double %.155.i16.1.i.i, %.155.i.1.i.i
  %.790.155.i.i = fmul double %.789.154.i.i, %.684.1.i.i
  %.791.156.i.i = fadd double %.155.i.1.i.i, %.790.155.i.i
  store double %.791.156.i.i, ptr %16, align 8
  %sunkaddr106.i.i = shl i64 %.150.i.1.i.i, 3
  %sunkaddr107.i.i = getelementptr i8, ptr %w10, i64 %sunkaddr106.i.i
  %sunkaddr108.i.i = getelementptr i8, ptr %sunkaddr107.i.i, i64 8
  %.676.1.1.i.i = load double, ptr %sunkaddr108.i.i, align 8
  %sunkaddr109.i.i = shl i64 %.150.i14.1.i.i, 3
  %sunkaddr110.i.i = getelementptr i8, ptr %w10, i64 %sunkaddr109.i.i
  %sunkaddr111.i.i = getelementptr i8, ptr %sunkaddr110.i.i, i64 8
  %.736.1.1.i.i = load double, ptr %sunkaddr111.i.i, align 8
  %.789.1.1.i.i = fsub double %.736.1.1.i.i, %.676.1.1.i.i
  %.790.1.1.i.i = fmul double %.684.1.i.i, %.789.1.1.i.i
  %.791.1.1.i.i = fadd double %.676.1.1.i.i, %.790.1.1.i.i
  %17 = getelementptr i8, ptr %16, i64 8
  store double %.791.1.1.i.i, ptr %17, align 8
  %sunkaddr114.i.i = getelementptr i8, ptr %sunkaddr107.i.i, i64 16
  %.676.2.1.i.i = load double, ptr %sunkaddr114.i.i, align 8
  %sunkaddr117.i.i = getelementptr i8, ptr %sunkaddr110.i.i, i64 16
  %.736.2.1.i.i = load double, ptr %sunkaddr117.i.i, align 8
  %.789.2.1.i.i = fsub double %.736.2.1.i.i, %.676.2.1.i.i
  %.790.2.1.i.i = fmul double %.684.1.i.i, %.789.2.1.i.i
  %.791.2.1.i.i = fadd double %.676.2.1.i.i, %.790.2.1.i.i
  %18 = getelementptr i8, ptr %16, i64 16
  store double %.791.2.1.i.i, ptr %18, align 8
  %sunkaddr118.i.i = shl i64 %.253.peel.i.i, 3
  %sunkaddr119.i.i = getelementptr inbounds i8, ptr %15, i64 %sunkaddr118.i.i
  %.279.2.pre.i.i = load i64, ptr %sunkaddr119.i.i, align 8
  %.208.i.2.pre.i.i = load double, ptr %sunkaddr144.i, align 8
  %.262.i.2.pre.i.i = load double, ptr %sunkaddr152.i, align 8
  %.370.i.2.pre.i.i = load double, ptr %sunkaddr147.i, align 8
  %.424.i.2.pre.i.i = load double, ptr %sunkaddr155.i, align 8
  %.533.i.2.pre.i.i = load double, ptr %sunkaddr150.i, align 8
  %.587.i.2.pre.i.i = load double, ptr %sunkaddr158.i, align 8
  br label %B408.1.i.i

B408.1.i.i:                                       ; preds = %B230.1.i.i, %B408.B408.1_crit_edge.i.i
  %.533.i.i35.i = phi double [ %.533.i.i36.i, %B408.B408.1_crit_edge.i.i ], [ %.533.i.2.pre.i.i, %B230.1.i.i ]
  %.370.i.i30.i = phi double [ %.370.i.i31.i, %B408.B408.1_crit_edge.i.i ], [ %.370.i.2.pre.i.i, %B230.1.i.i ]
  %.208.i.i25.i = phi double [ %.208.i.i26.i, %B408.B408.1_crit_edge.i.i ], [ %.208.i.2.pre.i.i, %B230.1.i.i ]
  %sunkaddr136.pre-phi.i.i = phi i64 [ %.pre.i6.i, %B408.B408.1_crit_edge.i.i ], [ %sunkaddr118.i.i, %B230.1.i.i ]
  %.587.i.2.i.i = phi double [ %.587.i.1.i.i, %B408.B408.1_crit_edge.i.i ], [ %.587.i.2.pre.i.i, %B230.1.i.i ]
  %.424.i.2.i.i = phi double [ %.424.i.1.i.i, %B408.B408.1_crit_edge.i.i ], [ %.424.i.2.pre.i.i, %B230.1.i.i ]
  %.262.i.2.i.i = phi double [ %.262.i.1.i.i, %B408.B408.1_crit_edge.i.i ], [ %.262.i.2.pre.i.i, %B230.1.i.i ]
  %.279.2.i.i = phi i64 [ %.354.1.i.i, %B408.B408.1_crit_edge.i.i ], [ %.279.2.pre.i.i, %B230.1.i.i ]
  %sunkaddr137.i.i = getelementptr inbounds i8, ptr %10, i64 %sunkaddr136.pre-phi.i.i
  %.354.2.i.i = load i64, ptr %sunkaddr137.i.i, align 8
  %.128.i.2.i.i = icmp slt i64 %.279.2.i.i, 0
  %.129.i.2.i.i = select i1 %.128.i.2.i.i, i64 %w11, i64 0
  %.130.i.2.i.i = add i64 %.129.i.2.i.i, %.279.2.i.i
  %.150.i.2.i.i = mul i64 %.130.i.2.i.i, %w12
  %.154.i.2.i.i = getelementptr double, ptr %w10, i64 %.150.i.2.i.i
  %.155.i.2.i.i = load double, ptr %.154.i.2.i.i, align 8
  %.209.i.2.i.i = fsub double %.155.i.2.i.i, %.208.i.i25.i
  %.263.i.2.i.i = fmul double %.262.i.2.i.i, %.209.i.2.i.i
  %.316.i.2.i.i = getelementptr i8, ptr %.154.i.2.i.i, i64 8
  %.317.i.2.i.i = load double, ptr %.316.i.2.i.i, align 8
  %.371.i.2.i.i = fsub double %.317.i.2.i.i, %.370.i.i30.i
  %.425.i.2.i.i = fmul double %.424.i.2.i.i, %.371.i.2.i.i
  %.426.i.2.i.i = fadd double %.263.i.2.i.i, %.425.i.2.i.i
  %.479.i.2.i.i = getelementptr i8, ptr %.154.i.2.i.i, i64 16
  %.480.i.2.i.i = load double, ptr %.479.i.2.i.i, align 8
  %.534.i.2.i.i = fsub double %.480.i.2.i.i, %.533.i.i35.i
  %.588.i.2.i.i = fmul double %.587.i.2.i.i, %.534.i.2.i.i
  %.589.i.2.i.i = fadd double %.426.i.2.i.i, %.588.i.2.i.i
  %.128.i11.2.i.i = icmp slt i64 %.354.2.i.i, 0
  %.129.i12.2.i.i = select i1 %.128.i11.2.i.i, i64 %w11, i64 0
  %.130.i13.2.i.i = add i64 %.129.i12.2.i.i, %.354.2.i.i
  %.150.i14.2.i.i = mul i64 %.130.i13.2.i.i, %w12
  %.154.i15.2.i.i = getelementptr double, ptr %w10, i64 %.150.i14.2.i.i
  %.155.i16.2.i.i = load double, ptr %.154.i15.2.i.i, align 8
  %.209.i23.2.i.i = fsub double %.155.i16.2.i.i, %.208.i.i25.i
  %.263.i29.2.i.i = fmul double %.262.i.2.i.i, %.209.i23.2.i.i
  %.316.i30.2.i.i = getelementptr i8, ptr %.154.i15.2.i.i, i64 8
  %.317.i31.2.i.i = load double, ptr %.316.i30.2.i.i, align 8
  %.371.i34.2.i.i = fsub double %.317.i31.2.i.i, %.370.i.i30.i
  %.425.i37.2.i.i = fmul double %.424.i.2.i.i, %.371.i34.2.i.i
  %.426.i38.2.i.i = fadd double %.263.i29.2.i.i, %.425.i37.2.i.i
  %.479.i39.2.i.i = getelementptr i8, ptr %.154.i15.2.i.i, i64 16
  %.480.i40.2.i.i = load double, ptr %.479.i39.2.i.i, align 8
  %.534.i43.2.i.i = fsub double %.480.i40.2.i.i, %.533.i.i35.i
  %.588.i46.2.i.i = fmul double %.587.i.2.i.i, %.534.i43.2.i.i
  %.589.i47.2.i.i = fadd double %.426.i38.2.i.i, %.588.i46.2.i.i
  %.485.2.i.i = fcmp oge double %.589.i.2.i.i, 0.000000e+00
  %.488.2.i.i = fcmp oge double %.589.i47.2.i.i, 0.000000e+00
  %.489.2.i.i = xor i1 %.485.2.i.i, %.488.2.i.i
  br i1 %.489.2.i.i, label %B230.2.i.i, label %B408.2.i.i

B230.2.i.i:                                       ; preds = %B408.1.i.i
  %.679.2.i.i = fsub double %.589.i.2.i.i, %.589.i47.2.i.i
  %.684.2.i.i = fdiv double %.589.i.2.i.i, %.679.2.i.i
  %.837.2.i.i = select i1 %.485.2.i.i, i64 0, i64 %w30
  %19 = getelementptr double, ptr %w28, i64 %.837.2.i.i
  %.789.257.i.i = fsub double %.155.i16.2.i.i, %.155.i.2.i.i
  %.790.258.i.i = fmul double %.789.257.i.i, %.684.2.i.i
  %.791.259.i.i = fadd double %.155.i.2.i.i, %.790.258.i.i
  store double %.791.259.i.i, ptr %19, align 8
  %sunkaddr138.i.i = shl i64 %.150.i.2.i.i, 3
  %sunkaddr139.i.i = getelementptr i8, ptr %w10, i64 %sunkaddr138.i.i
  %sunkaddr140.i.i = getelementptr i8, ptr %sunkaddr139.i.i, i64 8
  %.676.1.2.i.i = load double, ptr %sunkaddr140.i.i, align 8
  %sunkaddr141.i.i = shl i64 %.150.i14.2.i.i, 3
  %sunkaddr142.i.i = getelementptr i8, ptr %w10, i64 %sunkaddr141.i.i
  %sunkaddr143.i.i = getelementptr i8, ptr %sunkaddr142.i.i, i64 8
  %.736.1.2.i.i = load double, ptr %sunkaddr143.i.i, align 8
  %.789.1.2.i.i = fsub double %.736.1.2.i.i, %.676.1.2.i.i
  %.790.1.2.i.i = fmul double %.684.2.i.i, %.789.1.2.i.i
  %.791.1.2.i.i = fadd double %.676.1.2.i.i, %.790.1.2.i.i
  %20 = getelementptr i8, ptr %19, i64 8
  store double %.791.1.2.i.i, ptr %20, align 8
  %sunkaddr146.i.i = getelementptr i8, ptr %sunkaddr139.i.i, i64 16
  %.676.2.2.i.i = load double, ptr %sunkaddr146.i.i, align 8
  %sunkaddr149.i.i = getelementptr i8, ptr %sunkaddr142.i.i, i64 16
  %.736.2.2.i.i = load double, ptr %sunkaddr149.i.i, align 8
  %.789.2.2.i.i = fsub double %.736.2.2.i.i, %.676.2.2.i.i
  %.790.2.2.i.i = fmul double %.684.2.i.i, %.789.2.2.i.i
  %.791.2.2.i.i = fadd double %.676.2.2.i.i, %.790.2.2.i.i
  %21 = getelementptr i8, ptr %19, i64 16
  store double %.791.2.2.i.i, ptr %21, align 8
  %.923.pre.i.i = load double, ptr %sunkaddr144.i, align 8
  %.1033.pre.i.i = load double, ptr %sunkaddr147.i, align 8
  %.1145.pre.i.i = load double, ptr %sunkaddr150.i, align 8
  br label %B408.2.i.i

B408.2.i.i:                                       ; preds = %B230.2.i.i, %B408.1.i.i
  %.533.i.i34.i = phi double [ %.1145.pre.i.i, %B230.2.i.i ], [ %.533.i.i35.i, %B408.1.i.i ]
  %.370.i.i29.i = phi double [ %.1033.pre.i.i, %B230.2.i.i ], [ %.370.i.i30.i, %B408.1.i.i ]
  %.208.i.i24.i = phi double [ %.923.pre.i.i, %B230.2.i.i ], [ %.208.i.i25.i, %B408.1.i.i ]
  %.977.i.i = load double, ptr %w28, align 8
  %.978.i.i = fsub double %.208.i.i24.i, %.977.i.i
  %.1087.i.i = load double, ptr %.1086.i.i, align 8
  %.1088.i.i = fsub double %.370.i.i29.i, %.1087.i.i
  %.1201.i.i = load double, ptr %.1200.i.i, align 8
  %.1202.i.i = fsub double %.533.i.i34.i, %.1201.i.i
  %.1265.i.i = load double, ptr %.1264.i.i, align 8
  %.1320.i.i = fsub double %.1265.i.i, %.977.i.i
  %.1374.i.i = load double, ptr %.1373.i.i, align 8
  %.1429.i.i = fsub double %.1374.i.i, %.1087.i.i
  %.1483.i.i = load double, ptr %.1482.i.i, align 8
  %.1540.i.i = fsub double %.1483.i.i, %.1201.i.i
  %.10.i.i.i = fmul double %.1320.i.i, %.1320.i.i
  %.11.i.i.i = fmul double %.1540.i.i, %.1540.i.i
  %.12.i.i.i = fadd double %.10.i.i.i, %.11.i.i.i
  %.13.i.i7.i = fmul double %.1429.i.i, %.1429.i.i
  %.14.i.i8.i = fadd double %.13.i.i7.i, %.12.i.i.i
  %.1586.i.i = fcmp ogt double %.14.i.i8.i, 0.000000e+00
  br i1 %.1586.i.i, label %B678.endif.endif.endif.i.i, label %_ZN7msf_jax4host5solid5loops16segment_distanceB3v31B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedExx5ArrayIdLi2E1C7mutable7alignedE.exit.i

B678.endif.endif.endif.i.i:                       ; preds = %B408.2.i.i
  %.10.i4.i.i = fmul double %.978.i.i, %.1320.i.i
  %.11.i5.i.i = fmul double %.1202.i.i, %.1540.i.i
  %.12.i6.i.i = fadd double %.10.i4.i.i, %.11.i5.i.i
  %.13.i7.i.i = fmul double %.1088.i.i, %.1429.i.i
  %.14.i8.i.i = fadd double %.13.i7.i.i, %.12.i6.i.i
  %.1623.i.i = fdiv double %.14.i8.i.i, %.14.i.i8.i
  %.10.i48.i.i = fcmp olt double %.1623.i.i, 0.000000e+00
  %.11.i49.i.i = select i1 %.10.i48.i.i, double 0.000000e+00, double %.1623.i.i
  %.10.i50.i.i = fcmp ogt double %.11.i49.i.i, 1.000000e+00
  %.11.i51.i.i = select i1 %.10.i50.i.i, double 1.000000e+00, double %.11.i49.i.i
  br label %_ZN7msf_jax4host5solid5loops16segment_distanceB3v31B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedExx5ArrayIdLi2E1C7mutable7alignedE.exit.i

_ZN7msf_jax4host5solid5loops16segment_distanceB3v31B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedExx5ArrayIdLi2E1C7mutable7alignedE.exit.i: ; preds = %B678.endif.endif.endif.i.i, %B408.2.i.i
  %"$phi782.0.2.0.i.i" = phi double [ 0.000000e+00, %B408.2.i.i ], [ %.11.i51.i.i, %B678.endif.endif.endif.i.i ]
  %.1695.i.i = fmul double %.1320.i.i, %"$phi782.0.2.0.i.i"
  %.1699.i.i = fsub double %.978.i.i, %.1695.i.i
  %.1703.i.i = fmul double %.1429.i.i, %"$phi782.0.2.0.i.i"
  %.1707.i.i = fsub double %.1088.i.i, %.1703.i.i
  %.1711.i.i = fmul double %.1540.i.i, %"$phi782.0.2.0.i.i"
  %.1715.i.i = fsub double %.1202.i.i, %.1711.i.i
  %.7.i.i.i = fmul double %.1699.i.i, %.1699.i.i
  %.8.i.i.i = fmul double %.1707.i.i, %.1707.i.i
  %.9.i.i.i = fadd double %.7.i.i.i, %.8.i.i.i
  %.10.i9.i.i = fmul double %.1715.i.i, %.1715.i.i
  %.11.i10.i.i = fadd double %.10.i9.i.i, %.9.i.i.i
  %sqrt.i.i.i = tail call double @llvm.sqrt.f64(double %.11.i10.i.i)
  %.1081.i = fcmp olt double %sqrt.i.i.i, %best.3.2.ph.i
  br i1 %.1081.i, label %B544.i, label %B520.i

B520.i:                                           ; preds = %_ZN7msf_jax4host5solid5loops16segment_distanceB3v31B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedExx5ArrayIdLi2E1C7mutable7alignedE.exit.i
  %.1094.i = fcmp oeq double %sqrt.i.i.i, %best.3.2.ph.i
  %.1111.i = icmp slt i64 %.939.i, %which.2.2.ph.i
  %or.cond.i = select i1 %.1094.i, i1 %.1111.i, i1 false
  br i1 %or.cond.i, label %B544.i, label %B30.i.i

B544.i:                                           ; preds = %B520.i, %_ZN7msf_jax4host5solid5loops16segment_distanceB3v31B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedExx5ArrayIdLi2E1C7mutable7alignedE.exit.i
  br label %B30.i.i

B20.i.i:                                          ; preds = %B374.i
  %.28.i.i = shl nsw i64 %node.2.2.i, 1
  br label %B266.i

B30.i.i:                                          ; preds = %B266.i, %B386.endif.i, %B544.i, %B520.i, %B36.endif.endif.backedge.peel103.i.i
  %.533.i.i33.i = phi double [ %.533.i.i34.i, %B544.i ], [ %.533.i.i.i, %B36.endif.endif.backedge.peel103.i.i ], [ %.533.i.i.i, %B386.endif.i ], [ %.533.i.i34.i, %B520.i ], [ %.533.i.i.i, %B266.i ]
  %.370.i.i28.i = phi double [ %.370.i.i29.i, %B544.i ], [ %.370.i.i.i, %B36.endif.endif.backedge.peel103.i.i ], [ %.370.i.i.i, %B386.endif.i ], [ %.370.i.i29.i, %B520.i ], [ %.370.i.i.i, %B266.i ]
  %.208.i.i23.i = phi double [ %.208.i.i24.i, %B544.i ], [ %.208.i.i.i, %B36.endif.endif.backedge.peel103.i.i ], [ %.208.i.i.i, %B386.endif.i ], [ %.208.i.i24.i, %B520.i ], [ %.208.i.i.i, %B266.i ]
  %.83521.i = phi double [ %.533.i.i34.i, %B544.i ], [ %.835.i, %B36.endif.endif.backedge.peel103.i.i ], [ %.835.i, %B386.endif.i ], [ %.533.i.i34.i, %B520.i ], [ %.835.i, %B266.i ]
  %.78019.i = phi double [ %.370.i.i29.i, %B544.i ], [ %.780.i, %B36.endif.endif.backedge.peel103.i.i ], [ %.780.i, %B386.endif.i ], [ %.370.i.i29.i, %B520.i ], [ %.780.i, %B266.i ]
  %.72517.i = phi double [ %.208.i.i24.i, %B544.i ], [ %.725.i, %B36.endif.endif.backedge.peel103.i.i ], [ %.725.i, %B386.endif.i ], [ %.208.i.i24.i, %B520.i ], [ %.725.i, %B266.i ]
  %which.3.3102.i = phi i64 [ %.939.i, %B544.i ], [ %which.2.2.ph.i, %B36.endif.endif.backedge.peel103.i.i ], [ %which.2.2.ph.i, %B386.endif.i ], [ %which.2.2.ph.i, %B520.i ], [ %which.2.2.ph.i, %B266.i ]
  %first.5.3100.i = phi i64 [ %storemerge.i.i, %B544.i ], [ %first.6.2.ph.i, %B36.endif.endif.backedge.peel103.i.i ], [ %first.6.2.ph.i, %B386.endif.i ], [ %first.6.2.ph.i, %B520.i ], [ %first.6.2.ph.i, %B266.i ]
  %best.4.398.i = phi double [ %sqrt.i.i.i, %B544.i ], [ %best.3.2.ph.i, %B36.endif.endif.backedge.peel103.i.i ], [ %best.3.2.ph.i, %B386.endif.i ], [ %best.3.2.ph.i, %B520.i ], [ %best.3.2.ph.i, %B266.i ]
  %.36.i.i = add nsw i64 %node.2.2.i, 1
  %22 = and i64 %node.2.2.i, 1
  %.46.not.not.i.i = icmp eq i64 %22, 0
  br i1 %.46.not.not.i.i, label %B70.i.i, label %B50.i.i

B50.i.i:                                          ; preds = %B30.i.i, %B50.i.i
  %node.3.1.i.i = phi i64 [ %.49.i21.i, %B50.i.i ], [ %.36.i.i, %B30.i.i ]
  %.49.i21.i = ashr i64 %node.3.1.i.i, 1
  %23 = and i64 %node.3.1.i.i, 2
  %.55.not.i.i = icmp eq i64 %23, 0
  br i1 %.55.not.i.i, label %B50.i.i, label %B70.i.i

B70.i.i:                                          ; preds = %B50.i.i, %B30.i.i
  %node.4.0.i.i = phi i64 [ %.36.i.i, %B30.i.i ], [ %.49.i21.i, %B50.i.i ]
  %.60.i.i = icmp sgt i64 %node.4.0.i.i, 1
  br i1 %.60.i.i, label %B266.outer.i, label %B594.i

B594.i:                                           ; preds = %B70.i.i
  %.1211.i = fmul double %best.4.398.i, 3.000000e+00
  %exitcond.not.i = icmp eq i64 %w26, %.601.i
  br i1 %exitcond.not.i, label %B606.i, label %B236.i

B606.i:                                           ; preds = %B594.i, %B204.endif.i
  %first.3.1.lcssa.i = phi i64 [ %first.7.1.i, %B204.endif.i ], [ %first.5.3100.i, %B594.i ]
  %.1239.i = icmp sgt i64 %first.3.1.lcssa.i, -1
  br i1 %.1239.i, label %B606.B626.preheader_crit_edge.i, label %B1094.i

B606.B626.preheader_crit_edge.i:                  ; preds = %B606.i
  %.pre38.i = mul i64 %.720.i, %.30013411368.i
  %.pre39.i = mul i64 %.257.i23.i.i, %.30013411368.i
  br label %B626.preheader.i

B626.preheader.i:                                 ; preds = %B236.i, %B606.B626.preheader_crit_edge.i
  %sunkaddr161.pre-phi.i = phi i64 [ %.pre39.i, %B606.B626.preheader_crit_edge.i ], [ %sunkaddr151.i, %B236.i ]
  %sunkaddr159.pre-phi.i = phi i64 [ %.pre38.i, %B606.B626.preheader_crit_edge.i ], [ %sunkaddr.i, %B236.i ]
  %first.3.1.lcssa1428.i = phi i64 [ %first.3.1.lcssa.i, %B606.B626.preheader_crit_edge.i ], [ %first.3.11326.i, %B236.i ]
  %sunkaddr160.i = getelementptr i8, ptr %w0, i64 %sunkaddr159.pre-phi.i
  %sunkaddr162.i = getelementptr i8, ptr %w3, i64 %sunkaddr161.pre-phi.i
  %sunkaddr165.i = getelementptr i8, ptr %sunkaddr160.i, i64 8
  %sunkaddr168.i = getelementptr i8, ptr %sunkaddr162.i, i64 8
  %sunkaddr171.i = getelementptr i8, ptr %sunkaddr160.i, i64 16
  %sunkaddr174.i = getelementptr i8, ptr %sunkaddr162.i, i64 16
  %24 = add i64 %count.3.01371.i, %w27
  br label %B626.i

B626.i:                                           ; preds = %B694.endif.endif.endif.endif.endif.endif.endif.endif.i, %B626.preheader.i
  %count.5.1.i = phi i64 [ %count.3.01371.i, %B626.preheader.i ], [ %.1697.i, %B694.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %edge.3.1.i = phi i64 [ %first.3.1.lcssa1428.i, %B626.preheader.i ], [ %.1946.i, %B694.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %edge.3.1.fr.i = freeze i64 %edge.3.1.i
  %exitcond.i = icmp eq i64 %count.5.1.i, %24
  br i1 %exitcond.i, label %B1094.i, label %B650.i

B650.i:                                           ; preds = %B626.i
  %.1275.i = icmp eq i64 %w34, %count.5.1.i
  br i1 %.1275.i, label %_ZN7msf_jax4host5solid5loops5loopsB3v26B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B694.endif.endif.endif.endif.endif.endif.endif.endif.i

B1094.i:                                          ; preds = %B694.endif.endif.endif.endif.endif.endif.endif.endif.i, %B626.i, %B606.i
  %count.4.2.i = phi i64 [ %count.3.01371.i, %B606.i ], [ %count.3.01371.i, %B626.i ], [ %.1697.i, %B694.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %25 = getelementptr i64, ptr %w31, i64 %.30013411368.i
  store i64 %count.4.2.i, ptr %25, align 8
  %exitcond1425.not.i = icmp eq i64 %.307.i, %w1
  br i1 %exitcond1425.not.i, label %_ZN7msf_jax4host5solid5loops5loopsB3v26B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B108.i

B204.endif.i:                                     ; preds = %B148.endif.2.i.i, %B46.endif.i.i, %B108.i
  %first.7.1.i = phi i64 [ -1, %B108.i ], [ %storemerge.i.i.i, %B46.endif.i.i ], [ -1, %B148.endif.2.i.i ]
  br i1 %1, label %B606.i, label %B236.lr.ph.i

B236.lr.ph.i:                                     ; preds = %B204.endif.i
  %sunkaddr.i = mul i64 %.720.i, %.30013411368.i
  %sunkaddr144.i = getelementptr i8, ptr %w0, i64 %sunkaddr.i
  %sunkaddr147.i = getelementptr i8, ptr %sunkaddr144.i, i64 8
  %sunkaddr150.i = getelementptr i8, ptr %sunkaddr144.i, i64 16
  %sunkaddr151.i = mul i64 %.257.i23.i.i, %.30013411368.i
  %sunkaddr152.i = getelementptr i8, ptr %w3, i64 %sunkaddr151.i
  %sunkaddr155.i = getelementptr i8, ptr %sunkaddr152.i, i64 8
  %sunkaddr158.i = getelementptr i8, ptr %sunkaddr152.i, i64 16
  br label %B236.i

B386.endif.i:                                     ; preds = %B36.endif.endif.backedge.peel103.i.i, %B176.endif.peel75.i.i, %B176.endif.peel.i.i
  %storemerge.i.i = phi i64 [ %.pre.i.i, %B176.endif.peel75.i.i ], [ %.237.i.i, %B176.endif.peel.i.i ], [ %.pre161.i.i, %B36.endif.endif.backedge.peel103.i.i ]
  %.1005.i = icmp sgt i64 %storemerge.i.i, -1
  br i1 %.1005.i, label %B468.i, label %B30.i.i

B694.endif.endif.endif.endif.endif.endif.endif.endif.i: ; preds = %B650.i
  %.13771282.i = urem i64 %edge.3.1.fr.i, 3
  %.1435.i = getelementptr i64, ptr %w13, i64 %edge.3.1.fr.i
  %.1436.i = load i64, ptr %.1435.i, align 8
  %.128.i23.i = icmp slt i64 %.1436.i, 0
  %.129.i24.i = select i1 %.128.i23.i, i64 %w11, i64 0
  %.130.i.i = add i64 %.129.i24.i, %.1436.i
  %.150.i.i = mul i64 %.130.i.i, %w12
  %.154.i.i = getelementptr double, ptr %w10, i64 %.150.i.i
  %.155.i.i = load double, ptr %.154.i.i, align 8
  %.208.i.i = load double, ptr %sunkaddr160.i, align 8
  %.209.i.i = fsub double %.155.i.i, %.208.i.i
  %.262.i.i = load double, ptr %sunkaddr162.i, align 8
  %.263.i.i = fmul double %.209.i.i, %.262.i.i
  %.316.i.i = getelementptr i8, ptr %.154.i.i, i64 8
  %.317.i.i = load double, ptr %.316.i.i, align 8
  %.370.i.i = load double, ptr %sunkaddr165.i, align 8
  %.371.i.i = fsub double %.317.i.i, %.370.i.i
  %.424.i.i = load double, ptr %sunkaddr168.i, align 8
  %.425.i.i = fmul double %.371.i.i, %.424.i.i
  %.426.i.i = fadd double %.263.i.i, %.425.i.i
  %.479.i.i = getelementptr i8, ptr %.154.i.i, i64 16
  %.480.i.i = load double, ptr %.479.i.i, align 8
  %.533.i.i = load double, ptr %sunkaddr171.i, align 8
  %.534.i.i = fsub double %.480.i.i, %.533.i.i
  %.587.i.i = load double, ptr %sunkaddr174.i, align 8
  %.588.i.i = fmul double %.534.i.i, %.587.i.i
  %.589.i.i = fadd double %.426.i.i, %.588.i.i
  %.15191284.cmp.inv.i = icmp samesign ugt i64 %.13771282.i, 1
  %.15191284.v.i = select i1 %.15191284.cmp.inv.i, i64 -2, i64 1
  %.1540.i = add i64 %.15191284.v.i, %edge.3.1.fr.i
  %.1553.i = icmp slt i64 %.1540.i, 0
  %.1554.i = select i1 %.1553.i, i64 %w14, i64 0
  %26 = getelementptr i64, ptr %w13, i64 %.1540.i
  %.1568.i = getelementptr i64, ptr %26, i64 %.1554.i
  %.1569.i = load i64, ptr %.1568.i, align 8
  %.128.i26.i = icmp slt i64 %.1569.i, 0
  %.129.i27.i = select i1 %.128.i26.i, i64 %w11, i64 0
  %.130.i28.i = add i64 %.129.i27.i, %.1569.i
  %.150.i29.i = mul i64 %.130.i28.i, %w12
  %.154.i30.i = getelementptr double, ptr %w10, i64 %.150.i29.i
  %.155.i31.i = load double, ptr %.154.i30.i, align 8
  %.209.i35.i = fsub double %.155.i31.i, %.208.i.i
  %.263.i40.i = fmul double %.262.i.i, %.209.i35.i
  %.316.i41.i = getelementptr i8, ptr %.154.i30.i, i64 8
  %.317.i42.i = load double, ptr %.316.i41.i, align 8
  %.371.i45.i = fsub double %.317.i42.i, %.370.i.i
  %.425.i48.i = fmul double %.424.i.i, %.371.i45.i
  %.426.i49.i = fadd double %.263.i40.i, %.425.i48.i
  %.479.i50.i = getelementptr i8, ptr %.154.i30.i, i64 16
  %.480.i51.i = load double, ptr %.479.i50.i, align 8
  %.534.i54.i = fsub double %.480.i51.i, %.533.i.i
  %.588.i57.i = fmul double %.587.i.i, %.534.i54.i
  %.589.i58.i = fadd double %.426.i49.i, %.588.i57.i
  %.1497.i = sub nuw i64 %edge.3.1.fr.i, %.13771282.i
  %.1626.i = fsub double %.589.i.i, %.589.i58.i
  %.1630.i = fdiv double %.589.i.i, %.1626.i
  %.1646.i = icmp slt i64 %count.5.1.i, 0
  %27 = select i1 %.1646.i, i64 %2, i64 0
  %scevgep.i = getelementptr i8, ptr %w33, i64 %27
  %28 = shl i64 %count.5.1.i, 3
  %scevgep141.i = getelementptr i8, ptr %scevgep.i, i64 %28
  store i64 %edge.3.1.fr.i, ptr %scevgep141.i, align 8
  %29 = select i1 %.1646.i, i64 %3, i64 0
  %scevgep142.i = getelementptr i8, ptr %w35, i64 %29
  %scevgep143.i = getelementptr i8, ptr %scevgep142.i, i64 %28
  store double %.1630.i, ptr %scevgep143.i, align 8
  %30 = tail call { i64, i1 } @llvm.usub.with.overflow.i64(i64 %.13771282.i, i64 1)
  %math175.i = extractvalue { i64, i1 } %30, 0
  %ov176.i = extractvalue { i64, i1 } %30, 1
  %.17241286.i = select i1 %ov176.i, i64 2, i64 %math175.i
  %.1754.i = add nsw i64 %.17241286.i, %.1497.i
  %.1767.i = icmp slt i64 %.1754.i, 0
  %.1768.i = select i1 %.1767.i, i64 %w14, i64 0
  %31 = getelementptr i64, ptr %w13, i64 %.1754.i
  %.1782.i = getelementptr i64, ptr %31, i64 %.1768.i
  %.1783.i = load i64, ptr %.1782.i, align 8
  %.128.i59.i = icmp slt i64 %.1783.i, 0
  %.129.i60.i = select i1 %.128.i59.i, i64 %w11, i64 0
  %.130.i61.i = add i64 %.129.i60.i, %.1783.i
  %.150.i62.i = mul i64 %.130.i61.i, %w12
  %.154.i63.i = getelementptr double, ptr %w10, i64 %.150.i62.i
  %.155.i64.i = load double, ptr %.154.i63.i, align 8
  %.208.i67.i = load double, ptr %sunkaddr160.i, align 8
  %.209.i68.i = fsub double %.155.i64.i, %.208.i67.i
  %.262.i72.i = load double, ptr %sunkaddr162.i, align 8
  %.263.i73.i = fmul double %.209.i68.i, %.262.i72.i
  %.316.i74.i = getelementptr i8, ptr %.154.i63.i, i64 8
  %.317.i75.i = load double, ptr %.316.i74.i, align 8
  %.370.i77.i = load double, ptr %sunkaddr165.i, align 8
  %.371.i78.i = fsub double %.317.i75.i, %.370.i77.i
  %.424.i80.i = load double, ptr %sunkaddr168.i, align 8
  %.425.i81.i = fmul double %.371.i78.i, %.424.i80.i
  %.426.i82.i = fadd double %.263.i73.i, %.425.i81.i
  %.479.i83.i = getelementptr i8, ptr %.154.i63.i, i64 16
  %.480.i84.i = load double, ptr %.479.i83.i, align 8
  %.533.i86.i = load double, ptr %sunkaddr171.i, align 8
  %.534.i87.i = fsub double %.480.i84.i, %.533.i86.i
  %.587.i89.i = load double, ptr %sunkaddr174.i, align 8
  %.588.i90.i = fmul double %.534.i87.i, %.587.i89.i
  %.589.i91.i = fadd double %.426.i82.i, %.588.i90.i
  %.1697.i = add i64 %count.5.1.i, 1
  %.1841.i = fcmp ult double %.589.i91.i, 0.000000e+00
  %"$phi1056.2.2.3.i" = select i1 %.1841.i, i64 %.1754.i, i64 %.1540.i
  %.1930.i = icmp slt i64 %"$phi1056.2.2.3.i", 0
  %.1931.i = select i1 %.1930.i, i64 %w20, i64 0
  %32 = getelementptr i64, ptr %w19, i64 %"$phi1056.2.2.3.i"
  %.1945.i = getelementptr i64, ptr %32, i64 %.1931.i
  %.1946.i = load i64, ptr %.1945.i, align 8
  %.1956.i = icmp ne i64 %.1946.i, %first.3.1.lcssa1428.i
  %.1982.i = icmp sgt i64 %.1946.i, -1
  %or.cond1290.i = and i1 %.1956.i, %.1982.i
  br i1 %or.cond1290.i, label %B626.i, label %B1094.i

_ZN7msf_jax4host5solid5loops5loopsB3v26B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE232Mesh_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1094.i, %B650.i, %0
  %storemerge.i = phi i64 [ 1, %0 ], [ 0, %B650.i ], [ 1, %B1094.i ]
  ret i64 %storemerge.i
}

declare i64 @llvm.smax.i64(i64, i64)

declare double @atan2(double, double) local_unnamed_addr

define noundef i64 @msf_jax.host.solid.loops.measures(ptr readonly %words) local_unnamed_addr {
  %w0 = load ptr, ptr %words, align 8
  %p1 = getelementptr i8, ptr %words, i64 8
  %w1 = load i64, ptr %p1, align 8
  %p2 = getelementptr i8, ptr %words, i64 16
  %w2 = load i64, ptr %p2, align 8
  %p3 = getelementptr i8, ptr %words, i64 24
  %w3 = load ptr, ptr %p3, align 8
  %p5 = getelementptr i8, ptr %words, i64 40
  %w5 = load ptr, ptr %p5, align 8
  %p6 = getelementptr i8, ptr %words, i64 48
  %w6 = load i64, ptr %p6, align 8
  %p7 = getelementptr i8, ptr %words, i64 56
  %w7 = load i64, ptr %p7, align 8
  %p8 = getelementptr i8, ptr %words, i64 64
  %w8 = load ptr, ptr %p8, align 8
  %p9 = getelementptr i8, ptr %words, i64 72
  %w9 = load i64, ptr %p9, align 8
  %p10 = getelementptr i8, ptr %words, i64 80
  %w10 = load ptr, ptr %p10, align 8
  %p13 = getelementptr i8, ptr %words, i64 104
  %w13 = load ptr, ptr %p13, align 8
  %p14 = getelementptr i8, ptr %words, i64 112
  %w14 = load i64, ptr %p14, align 8
  %.1801245.not.i = icmp slt i64 %w9, 1
  br i1 %.1801245.not.i, label %_ZN7msf_jax4host5solid5loops8measuresB3v32B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi2E1C7mutable7alignedE.exit, label %B68.endif.lr.ph.i

B68.endif.lr.ph.i:                                ; preds = %0
  %p15 = getelementptr i8, ptr %words, i64 120
  %w15 = load i64, ptr %p15, align 8
  %p12 = getelementptr i8, ptr %words, i64 96
  %w12 = load double, ptr %p12, align 8
  %p4 = getelementptr i8, ptr %words, i64 32
  %w4 = load i64, ptr %p4, align 8
  %.2663.i = fmul double %w12, %w12
  %1 = shl i64 %w4, 3
  %.315.i = shl i64 %w15, 3
  br label %B68.endif.i

B838.i:                                           ; preds = %B278.endif.endif.endif.i, %B68.endif.B838_crit_edge.i
  %.1586.i = phi double [ %.1586.pre.i, %B68.endif.B838_crit_edge.i ], [ %.1339.i, %B278.endif.endif.endif.i ]
  %.1588.i = fcmp ogt double %.1586.i, 0.000000e+00
  br i1 %.1588.i, label %B950.endif.i, label %B1896.i

B1696.2.i:                                        ; preds = %B986.lr.ph.i, %B1696.2.i
  %lsr.iv86.i = phi i64 [ %lsr.iv.next87.i, %B1696.2.i ], [ %7, %B986.lr.ph.i ]
  %.3062.284.i = phi double [ %.3062.2.i, %B1696.2.i ], [ %.promoted83.i, %B986.lr.ph.i ]
  %.2994.282.i = phi double [ %.2994.2.i, %B1696.2.i ], [ %.promoted81.i, %B986.lr.ph.i ]
  %.2928.280.i = phi double [ %.2928.2.i, %B1696.2.i ], [ %.promoted79.i, %B986.lr.ph.i ]
  %.2861.278.i = phi double [ %.2862.2.i, %B1696.2.i ], [ %.promoted77.i, %B986.lr.ph.i ]
  %.3062.176.i = phi double [ %.3062.1.i, %B1696.2.i ], [ %.promoted75.i, %B986.lr.ph.i ]
  %.2994.174.i = phi double [ %.2994.1.i, %B1696.2.i ], [ %.promoted73.i, %B986.lr.ph.i ]
  %.2928.172.i = phi double [ %.2928.1.i, %B1696.2.i ], [ %.promoted71.i, %B986.lr.ph.i ]
  %.2861.170.i = phi double [ %.2862.1.i, %B1696.2.i ], [ %.promoted69.i, %B986.lr.ph.i ]
  %.306268.i = phi double [ %.3062.i, %B1696.2.i ], [ %.promoted67.i, %B986.lr.ph.i ]
  %.299466.i = phi double [ %.2994.i, %B1696.2.i ], [ %.promoted65.i, %B986.lr.ph.i ]
  %.292864.i = phi double [ %.2928.i, %B1696.2.i ], [ %.promoted63.i, %B986.lr.ph.i ]
  %.286262.i = phi double [ %.2862.i, %B1696.2.i ], [ %.promoted.i, %B986.lr.ph.i ]
  %.256061.i = phi double [ %.2599.i, %B1696.2.i ], [ %.2559.promoted.i, %B986.lr.ph.i ]
  %.189611241146.i = phi i64 [ %.1903.i, %B1696.2.i ], [ %first.2.01254.i, %B986.lr.ph.i ]
  %.1903.i = add i64 %.189611241146.i, 1
  %.1934.i = icmp slt i64 %.1903.i, %.247.i
  %spec.select1078.i = select i1 %.1934.i, i64 %.1903.i, i64 %first.2.01254.i
  %.1976.i = icmp slt i64 %.189611241146.i, 0
  %.1977.i = select i1 %.1976.i, i64 %w1, i64 0
  %.1978.i = add i64 %.1977.i, %.189611241146.i
  %.1998.i = mul i64 %.1978.i, %w2
  %.2002.i = getelementptr double, ptr %w0, i64 %.1998.i
  %.2003.i = load double, ptr %.2002.i, align 8
  %.2057.i = getelementptr i8, ptr %.2002.i, i64 8
  %.2058.i = load double, ptr %.2057.i, align 8
  %.2112.i = getelementptr i8, ptr %.2002.i, i64 16
  %.2113.i = load double, ptr %.2112.i, align 8
  %.2140.i = icmp slt i64 %spec.select1078.i, 0
  %.2141.i = select i1 %.2140.i, i64 %w1, i64 0
  %.2142.i = add i64 %.2141.i, %spec.select1078.i
  %.2162.i = mul i64 %.2142.i, %w2
  %.2166.i = getelementptr double, ptr %w0, i64 %.2162.i
  %.2167.i = load double, ptr %.2166.i, align 8
  %.2220.i = getelementptr i8, ptr %.2166.i, i64 8
  %.2221.i = load double, ptr %.2220.i, align 8
  %.2274.i = getelementptr i8, ptr %.2166.i, i64 16
  %.2275.i = load double, ptr %.2274.i, align 8
  %.2276.i = fadd double %.2003.i, %.2167.i
  %.2281.i = fmul double %.2276.i, 5.000000e-01
  %.2282.i = fadd double %.2058.i, %.2221.i
  %.2287.i = fmul double %.2282.i, 5.000000e-01
  %.2288.i = fadd double %.2113.i, %.2275.i
  %.2293.i = fmul double %.2288.i, 5.000000e-01
  %.2403.i = fsub double %.2167.i, %.2003.i
  %.2404.i = fsub double %.2221.i, %.2058.i
  %.2405.i = fsub double %.2275.i, %.2113.i
  %.7.i.i = fmul double %.2403.i, %.2403.i
  %.8.i.i = fmul double %.2404.i, %.2404.i
  %.9.i.i = fadd double %.7.i.i, %.8.i.i
  %.10.i22.i = fmul double %.2405.i, %.2405.i
  %.11.i23.i = fadd double %.9.i.i, %.10.i22.i
  %sqrt.i.i = tail call double @llvm.sqrt.f64(double %.11.i23.i)
  %2 = select i1 %.1976.i, i64 %1, i64 0
  %scevgep.i = getelementptr i8, ptr %w3, i64 %2
  %3 = shl i64 %.189611241146.i, 3
  %scevgep88.i = getelementptr i8, ptr %scevgep.i, i64 %3
  %.2460.i = load double, ptr %scevgep88.i, align 8
  %.2465.i = fsub double %.2003.i, %.1772.i
  %.2467.i = fsub double %.2058.i, %.1772.1.i
  %.2469.i = fsub double %.2113.i, %.1772.2.i
  %.7.i35.i = fmul double %.2465.i, %.2465.i
  %.8.i36.i = fmul double %.2467.i, %.2467.i
  %.9.i37.i = fadd double %.7.i35.i, %.8.i36.i
  %.10.i38.i = fmul double %.2469.i, %.2469.i
  %.11.i39.i = fadd double %.9.i37.i, %.10.i38.i
  %sqrt.i40.i = tail call double @llvm.sqrt.f64(double %.11.i39.i)
  %.2497.i = fsub double %.2281.i, %.1772.i
  %.2500.i = fsub double %.2287.i, %.1772.1.i
  %.2503.i = fsub double %.2293.i, %.1772.2.i
  %.7.i41.i = fmul double %.2497.i, %.2497.i
  %.8.i42.i = fmul double %.2500.i, %.2500.i
  %.9.i43.i = fadd double %.7.i41.i, %.8.i42.i
  %.10.i44.i = fmul double %.2503.i, %.2503.i
  %.11.i45.i = fadd double %.9.i43.i, %.10.i44.i
  %sqrt.i46.i = tail call double @llvm.sqrt.f64(double %.11.i45.i)
  %.2563.i = fsub double %.2167.i, %.1772.i
  %.2565.i = fsub double %.2221.i, %.1772.1.i
  %.2567.i = fsub double %.2275.i, %.1772.2.i
  %.7.i47.i = fmul double %.2563.i, %.2563.i
  %.8.i48.i = fmul double %.2565.i, %.2565.i
  %.9.i49.i = fadd double %.7.i47.i, %.8.i48.i
  %.10.i50.i = fmul double %.2567.i, %.2567.i
  %.11.i51.i = fadd double %.9.i49.i, %.10.i50.i
  %sqrt.i52.i = tail call double @llvm.sqrt.f64(double %.11.i51.i)
  %.2529.i = fmul double %sqrt.i46.i, 4.000000e+00
  %.2530.i = fadd double %sqrt.i40.i, %.2529.i
  %.2592.i = fadd double %sqrt.i52.i, %.2530.i
  %.2597.i = fdiv double %.2592.i, 6.000000e+00
  %.2598.i = fmul double %sqrt.i.i, %.2597.i
  %.2599.i = fadd double %.256061.i, %.2598.i
  store double %.2599.i, ptr %sunkaddr174.i, align 8
  %.2630.i = fmul double %.2460.i, %.2460.i
  %.2632.i = fsub double 1.000000e+00, %.2630.i
  %.10.i53.i = fcmp olt double %.2632.i, 0.000000e+00
  %.11.i54.i = select i1 %.10.i53.i, double 0.000000e+00, double %.2632.i
  %.2664.i = fadd double %.2663.i, %.11.i54.i
  %sqrt.i = tail call double @llvm.sqrt.f64(double %.2664.i)
  %.2669.i = fdiv double %sqrt.i.i, %sqrt.i
  %.2670.i = fmul double %.2460.i, %.2669.i
  %.2825.i = fmul double %.2497.i, %.2670.i
  %.2862.i = fadd double %.286262.i, %.2825.i
  store double %.2862.i, ptr %sunkaddr177.i, align 8
  %.2927.i = fmul double %.2281.i, %.2825.i
  %.2928.i = fadd double %.292864.i, %.2927.i
  store double %.2928.i, ptr %sunkaddr180.i, align 8
  %.2993.i = fmul double %.2287.i, %.2825.i
  %.2994.i = fadd double %.299466.i, %.2993.i
  store double %.2994.i, ptr %sunkaddr183.i, align 8
  %.3061.i = fmul double %.2293.i, %.2825.i
  %.3062.i = fadd double %.306268.i, %.3061.i
  store double %.3062.i, ptr %sunkaddr186.i, align 8
  %.2825.1.i = fmul double %.2500.i, %.2670.i
  %.2862.1.i = fadd double %.2861.170.i, %.2825.1.i
  store double %.2862.1.i, ptr %sunkaddr189.i, align 8
  %.2927.1.i = fmul double %.2281.i, %.2825.1.i
  %.2928.1.i = fadd double %.2928.172.i, %.2927.1.i
  store double %.2928.1.i, ptr %sunkaddr192.i, align 8
  %.2993.1.i = fmul double %.2287.i, %.2825.1.i
  %.2994.1.i = fadd double %.2994.174.i, %.2993.1.i
  store double %.2994.1.i, ptr %sunkaddr195.i, align 8
  %.3061.1.i = fmul double %.2293.i, %.2825.1.i
  %.3062.1.i = fadd double %.3062.176.i, %.3061.1.i
  store double %.3062.1.i, ptr %sunkaddr198.i, align 8
  %.2825.2.i = fmul double %.2503.i, %.2670.i
  %.2862.2.i = fadd double %.2861.278.i, %.2825.2.i
  store double %.2862.2.i, ptr %sunkaddr201.i, align 8
  %.2927.2.i = fmul double %.2281.i, %.2825.2.i
  %.2928.2.i = fadd double %.2928.280.i, %.2927.2.i
  store double %.2928.2.i, ptr %sunkaddr204.i, align 8
  %.2993.2.i = fmul double %.2287.i, %.2825.2.i
  %.2994.2.i = fadd double %.2994.282.i, %.2993.2.i
  store double %.2994.2.i, ptr %sunkaddr207.i, align 8
  %.3061.2.i = fmul double %.2293.i, %.2825.2.i
  %.3062.2.i = fadd double %.3062.284.i, %.3061.2.i
  store double %.3062.2.i, ptr %sunkaddr210.i, align 8
  %lsr.iv.next87.i = add i64 %lsr.iv86.i, -1
  %.1890.i = icmp samesign ugt i64 %lsr.iv.next87.i, 1
  br i1 %.1890.i, label %B1696.2.i, label %B1896.i

B1896.i:                                          ; preds = %B1696.2.i, %B950.endif.i, %B838.i
  %exitcond.not.i = icmp eq i64 %.193.i, %w9
  br i1 %exitcond.not.i, label %_ZN7msf_jax4host5solid5loops8measuresB3v32B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi2E1C7mutable7alignedE.exit, label %B68.endif.i

B68.endif.i:                                      ; preds = %B1896.i, %B68.endif.lr.ph.i
  %first.2.01254.i = phi i64 [ 0, %B68.endif.lr.ph.i ], [ %.247.i, %B1896.i ]
  %.18611601252.i = phi i64 [ 0, %B68.endif.lr.ph.i ], [ %.193.i, %B1896.i ]
  %.193.i = add nuw nsw i64 %.18611601252.i, 1
  %4 = getelementptr i64, ptr %w8, i64 %.18611601252.i
  %.247.i = load i64, ptr %4, align 8
  %5 = getelementptr i64, ptr %w10, i64 %.18611601252.i
  %.277.i = load i64, ptr %5, align 8
  %.296.i = icmp slt i64 %.277.i, 0
  %.297.i = select i1 %.296.i, i64 %w14, i64 0
  %.298.i = add i64 %.297.i, %.277.i
  %.409.i = select i1 %.296.i, i64 %w6, i64 0
  %.410.i = add i64 %.409.i, %.277.i
  %.430.i = mul i64 %.410.i, %w7
  %.434.i = getelementptr double, ptr %w5, i64 %.430.i
  %.435.i = load double, ptr %.434.i, align 8
  %.518.i = getelementptr i8, ptr %.434.i, i64 8
  %.519.i = load double, ptr %.518.i, align 8
  %.602.i = getelementptr i8, ptr %.434.i, i64 16
  %.603.i = load double, ptr %.602.i, align 8
  %.651.i = sub i64 %.247.i, %first.2.01254.i
  %.652.i = icmp sgt i64 %.651.i, 0
  %..651.i = tail call i64 @llvm.smax.i64(i64 %.651.i, i64 0)
  %sunkaddr130.i = mul i64 %.315.i, %.298.i
  %sunkaddr131.i = getelementptr i8, ptr %w13, i64 %sunkaddr130.i
  br i1 %.652.i, label %B246.lr.ph.i, label %B68.endif.B838_crit_edge.i

B68.endif.B838_crit_edge.i:                       ; preds = %B68.endif.i
  %sunkaddr129.i = getelementptr i8, ptr %sunkaddr131.i, i64 24
  %.1586.pre.i = load double, ptr %sunkaddr129.i, align 8
  br label %B838.i

B246.lr.ph.i:                                     ; preds = %B68.endif.i
  %.317.promoted.i = load double, ptr %sunkaddr131.i, align 8
  %sunkaddr134.i = getelementptr i8, ptr %sunkaddr131.i, i64 8
  %.1211.promoted.i = load double, ptr %sunkaddr134.i, align 8
  %sunkaddr137.i = getelementptr i8, ptr %sunkaddr131.i, i64 16
  %.1274.promoted.i = load double, ptr %sunkaddr137.i, align 8
  %sunkaddr140.i = getelementptr i8, ptr %sunkaddr131.i, i64 24
  %.1337.promoted.i = load double, ptr %sunkaddr140.i, align 8
  %sunkaddr143.i = getelementptr i8, ptr %sunkaddr131.i, i64 32
  %.1398.promoted.i = load double, ptr %sunkaddr143.i, align 8
  %sunkaddr146.i = getelementptr i8, ptr %sunkaddr131.i, i64 40
  %.1485.promoted.i = load double, ptr %sunkaddr146.i, align 8
  %6 = add nuw i64 %..651.i, 1
  br label %B278.endif.endif.endif.i

B278.endif.endif.endif.i:                         ; preds = %B278.endif.endif.endif.i, %B246.lr.ph.i
  %lsr.iv.i = phi i64 [ %lsr.iv.next.i, %B278.endif.endif.endif.i ], [ %6, %B246.lr.ph.i ]
  %.148660.i = phi double [ %.1515.i, %B278.endif.endif.endif.i ], [ %.1485.promoted.i, %B246.lr.ph.i ]
  %.139959.i = phi double [ %.1426.i, %B278.endif.endif.endif.i ], [ %.1398.promoted.i, %B246.lr.ph.i ]
  %.133858.i = phi double [ %.1339.i, %B278.endif.endif.endif.i ], [ %.1337.promoted.i, %B246.lr.ph.i ]
  %.127557.i = phi double [ %.1278.i, %B278.endif.endif.endif.i ], [ %.1274.promoted.i, %B246.lr.ph.i ]
  %.121256.i = phi double [ %.1215.i, %B278.endif.endif.endif.i ], [ %.1211.promoted.i, %B246.lr.ph.i ]
  %.115255.i = phi double [ %.1152.i, %B278.endif.endif.endif.i ], [ %.317.promoted.i, %B246.lr.ph.i ]
  %.70110981102.i = phi i64 [ %.708.i, %B278.endif.endif.endif.i ], [ %first.2.01254.i, %B246.lr.ph.i ]
  %.708.i = add i64 %.70110981102.i, 1
  %.739.i = icmp slt i64 %.708.i, %.247.i
  %spec.select.i = select i1 %.739.i, i64 %.708.i, i64 %first.2.01254.i
  %.781.i = icmp slt i64 %.70110981102.i, 0
  %.782.i = select i1 %.781.i, i64 %w1, i64 0
  %.783.i = add i64 %.782.i, %.70110981102.i
  %.803.i = mul i64 %.783.i, %w2
  %.807.i = getelementptr double, ptr %w0, i64 %.803.i
  %.808.i = load double, ptr %.807.i, align 8
  %.862.i = getelementptr i8, ptr %.807.i, i64 8
  %.863.i = load double, ptr %.862.i, align 8
  %.919.i = getelementptr i8, ptr %.807.i, i64 16
  %.920.i = load double, ptr %.919.i, align 8
  %.947.i = icmp slt i64 %spec.select.i, 0
  %.948.i = select i1 %.947.i, i64 %w1, i64 0
  %.949.i = add i64 %.948.i, %spec.select.i
  %.969.i = mul i64 %.949.i, %w2
  %.973.i = getelementptr double, ptr %w0, i64 %.969.i
  %.974.i = load double, ptr %.973.i, align 8
  %.1027.i = getelementptr i8, ptr %.973.i, i64 8
  %.1028.i = load double, ptr %.1027.i, align 8
  %.1081.i = getelementptr i8, ptr %.973.i, i64 16
  %.1082.i = load double, ptr %.1081.i, align 8
  %.1084.i = fmul double %.863.i, %.1082.i
  %.1085.i = fmul double %.920.i, %.1028.i
  %.1086.i = fsub double %.1084.i, %.1085.i
  %.1087.i = fmul double %.920.i, %.974.i
  %.1088.i = fmul double %.808.i, %.1082.i
  %.1089.i = fsub double %.1087.i, %.1088.i
  %.1090.i = fmul double %.808.i, %.1028.i
  %.1091.i = fmul double %.863.i, %.974.i
  %.1092.i = fsub double %.1090.i, %.1091.i
  %.10.i.i = fmul double %.435.i, %.1086.i
  %.11.i.i = fmul double %.603.i, %.1092.i
  %.12.i.i = fadd double %.11.i.i, %.10.i.i
  %.13.i.i = fmul double %.519.i, %.1089.i
  %.14.i.i = fadd double %.13.i.i, %.12.i.i
  %.1150.i = fadd double %.808.i, %.974.i
  %.1151.i = fmul double %.1150.i, %.14.i.i
  %.1152.i = fadd double %.115255.i, %.1151.i
  store double %.1152.i, ptr %sunkaddr131.i, align 8
  %.1213.i = fadd double %.863.i, %.1028.i
  %.1214.i = fmul double %.1213.i, %.14.i.i
  %.1215.i = fadd double %.121256.i, %.1214.i
  store double %.1215.i, ptr %sunkaddr134.i, align 8
  %.1276.i = fadd double %.920.i, %.1082.i
  %.1277.i = fmul double %.1276.i, %.14.i.i
  %.1278.i = fadd double %.127557.i, %.1277.i
  store double %.1278.i, ptr %sunkaddr137.i, align 8
  %.1339.i = fadd double %.133858.i, %.14.i.i
  store double %.1339.i, ptr %sunkaddr140.i, align 8
  %.10.i24.i = fmul double %.808.i, %.974.i
  %.11.i25.i = fmul double %.920.i, %.1082.i
  %.12.i26.i = fadd double %.10.i24.i, %.11.i25.i
  %.13.i27.i = fmul double %.863.i, %.1028.i
  %.14.i28.i = fadd double %.13.i27.i, %.12.i26.i
  %.1425.i = tail call double @atan2(double %.14.i.i, double %.14.i28.i)
  %.1426.i = fadd double %.139959.i, %.1425.i
  store double %.1426.i, ptr %sunkaddr143.i, align 8
  %.1488.i = fsub double %.974.i, %.808.i
  %.1489.i = fsub double %.1028.i, %.863.i
  %.1490.i = fsub double %.1082.i, %.920.i
  %.7.i29.i = fmul double %.1488.i, %.1488.i
  %.8.i30.i = fmul double %.1489.i, %.1489.i
  %.9.i31.i = fadd double %.7.i29.i, %.8.i30.i
  %.10.i32.i = fmul double %.1490.i, %.1490.i
  %.11.i33.i = fadd double %.9.i31.i, %.10.i32.i
  %sqrt.i34.i = tail call double @llvm.sqrt.f64(double %.11.i33.i)
  %.1515.i = fadd double %.148660.i, %sqrt.i34.i
  store double %.1515.i, ptr %sunkaddr146.i, align 8
  %lsr.iv.next.i = add i64 %lsr.iv.i, -1
  %.695.i = icmp samesign ugt i64 %lsr.iv.next.i, 1
  br i1 %.695.i, label %B278.endif.endif.endif.i, label %B838.i

B950.endif.i:                                     ; preds = %B838.i
  %.1736.i = load double, ptr %sunkaddr131.i, align 8
  %.1768.i = fmul double %.1586.i, 3.000000e+00
  %.1772.i = fdiv double %.1736.i, %.1768.i
  store double %.1772.i, ptr %sunkaddr131.i, align 8
  %sunkaddr168.i = getelementptr i8, ptr %sunkaddr131.i, i64 8
  %.1736.1.i = load double, ptr %sunkaddr168.i, align 8
  %.1772.1.i = fdiv double %.1736.1.i, %.1768.i
  store double %.1772.1.i, ptr %sunkaddr168.i, align 8
  %sunkaddr171.i = getelementptr i8, ptr %sunkaddr131.i, i64 16
  %.1736.2.i = load double, ptr %sunkaddr171.i, align 8
  %.1772.2.i = fdiv double %.1736.2.i, %.1768.i
  store double %.1772.2.i, ptr %sunkaddr171.i, align 8
  %.18901143.not.i = icmp slt i64 %.651.i, 1
  br i1 %.18901143.not.i, label %B1896.i, label %B986.lr.ph.i

B986.lr.ph.i:                                     ; preds = %B950.endif.i
  %sunkaddr174.i = getelementptr i8, ptr %sunkaddr131.i, i64 48
  %.2559.promoted.i = load double, ptr %sunkaddr174.i, align 8
  %sunkaddr177.i = getelementptr i8, ptr %sunkaddr131.i, i64 56
  %.promoted.i = load double, ptr %sunkaddr177.i, align 8
  %sunkaddr180.i = getelementptr i8, ptr %sunkaddr131.i, i64 80
  %.promoted63.i = load double, ptr %sunkaddr180.i, align 8
  %sunkaddr183.i = getelementptr i8, ptr %sunkaddr131.i, i64 88
  %.promoted65.i = load double, ptr %sunkaddr183.i, align 8
  %sunkaddr186.i = getelementptr i8, ptr %sunkaddr131.i, i64 96
  %.promoted67.i = load double, ptr %sunkaddr186.i, align 8
  %sunkaddr189.i = getelementptr i8, ptr %sunkaddr131.i, i64 64
  %.promoted69.i = load double, ptr %sunkaddr189.i, align 8
  %sunkaddr192.i = getelementptr i8, ptr %sunkaddr131.i, i64 104
  %.promoted71.i = load double, ptr %sunkaddr192.i, align 8
  %sunkaddr195.i = getelementptr i8, ptr %sunkaddr131.i, i64 112
  %.promoted73.i = load double, ptr %sunkaddr195.i, align 8
  %sunkaddr198.i = getelementptr i8, ptr %sunkaddr131.i, i64 120
  %.promoted75.i = load double, ptr %sunkaddr198.i, align 8
  %sunkaddr201.i = getelementptr i8, ptr %sunkaddr131.i, i64 72
  %.promoted77.i = load double, ptr %sunkaddr201.i, align 8
  %sunkaddr204.i = getelementptr i8, ptr %sunkaddr131.i, i64 128
  %.promoted79.i = load double, ptr %sunkaddr204.i, align 8
  %sunkaddr207.i = getelementptr i8, ptr %sunkaddr131.i, i64 136
  %.promoted81.i = load double, ptr %sunkaddr207.i, align 8
  %sunkaddr210.i = getelementptr i8, ptr %sunkaddr131.i, i64 144
  %.promoted83.i = load double, ptr %sunkaddr210.i, align 8
  %7 = add nuw i64 %..651.i, 1
  br label %B1696.2.i

_ZN7msf_jax4host5solid5loops8measuresB3v32B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi2E1C7mutable7alignedE.exit: ; preds = %B1896.i, %0
  ret i64 0
}

declare double @sqrt(double) local_unnamed_addr

define noundef i64 @msf_jax.host.thin.fronts.spread(ptr readonly %words) local_unnamed_addr {
  %w0 = load ptr, ptr %words, align 8
  %p1 = getelementptr i8, ptr %words, i64 8
  %w1 = load i64, ptr %p1, align 8
  %p2 = getelementptr i8, ptr %words, i64 16
  %w2 = load i64, ptr %p2, align 8
  %p3 = getelementptr i8, ptr %words, i64 24
  %w3 = load ptr, ptr %p3, align 8
  %p4 = getelementptr i8, ptr %words, i64 32
  %w4 = load i64, ptr %p4, align 8
  %p5 = getelementptr i8, ptr %words, i64 40
  %w5 = load i64, ptr %p5, align 8
  %p8 = getelementptr i8, ptr %words, i64 64
  %w8 = load ptr, ptr %p8, align 8
  %p9 = getelementptr i8, ptr %words, i64 72
  %w9 = load i64, ptr %p9, align 8
  %p10 = getelementptr i8, ptr %words, i64 80
  %w10 = load ptr, ptr %p10, align 8
  %p11 = getelementptr i8, ptr %words, i64 88
  %w11 = load i64, ptr %p11, align 8
  %p15 = getelementptr i8, ptr %words, i64 120
  %w15 = load ptr, ptr %p15, align 8
  %p16 = getelementptr i8, ptr %words, i64 128
  %w16 = load i64, ptr %p16, align 8
  %p17 = getelementptr i8, ptr %words, i64 136
  %w17 = load ptr, ptr %p17, align 8
  %p18 = getelementptr i8, ptr %words, i64 144
  %w18 = load i64, ptr %p18, align 8
  %p25 = getelementptr i8, ptr %words, i64 200
  %w25 = load ptr, ptr %p25, align 8
  %p26 = getelementptr i8, ptr %words, i64 208
  %w26 = load i64, ptr %p26, align 8
  %p27 = getelementptr i8, ptr %words, i64 216
  %w27 = load ptr, ptr %p27, align 8
  %p28 = getelementptr i8, ptr %words, i64 224
  %w28 = load i64, ptr %p28, align 8
  %p31 = getelementptr i8, ptr %words, i64 248
  %w31 = load ptr, ptr %p31, align 8
  %p32 = getelementptr i8, ptr %words, i64 256
  %w32 = load i64, ptr %p32, align 8
  %.195645.i = icmp sgt i64 %w32, 0
  br i1 %.195645.i, label %B14.i, label %_ZN7msf_jax4host4thin6fronts6spreadB3v33B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE.exit

B14.i:                                            ; preds = %0, %B12.backedge.i
  %size.4.0647.i = phi i64 [ %.619.i.i, %B12.backedge.i ], [ 0, %0 ]
  %.207.i = shl i64 %size.4.0647.i, 3
  %.211.i = getelementptr i8, ptr %w31, i64 %.207.i
  %.213.i = load i64, ptr %.211.i, align 8
  %.255.i = icmp slt i64 %.213.i, 0
  %.256.i = select i1 %.255.i, i64 %w16, i64 0
  %1 = getelementptr double, ptr %w15, i64 %.213.i
  %.270.i = getelementptr double, ptr %1, i64 %.256.i
  store double 0.000000e+00, ptr %.270.i, align 8
  %.96.i.not.i = icmp eq i64 %size.4.0647.i, 0
  br i1 %.96.i.not.i, label %B12.backedge.i, label %B20.else.if.i.i

B20.else.if.i.i:                                  ; preds = %B14.i
  %.108.i.i = add nsw i64 %size.4.0647.i, -1
  %.129416426.i.i = lshr i64 %.108.i.i, 1
  %.178.i.i = getelementptr double, ptr %w25, i64 %.129416426.i.i
  %.179.i.i = load double, ptr %.178.i.i, align 8
  %.181.i.i = fcmp ogt double %.179.i.i, 0.000000e+00
  br i1 %.181.i.i, label %B66.else.if.i.i, label %B12.backedge.i

B66.else.if.i.i:                                  ; preds = %B20.else.if.i.i, %B204.else.if.i.i
  %at.2.1.i.i = phi i64 [ %.208418427.i.i, %B204.else.if.i.i ], [ %size.4.0647.i, %B20.else.if.i.i ]
  %.189.i.i = add nsw i64 %at.2.1.i.i, -1
  %.208418427.i.i = lshr i64 %.189.i.i, 1
  %.257.i.i = getelementptr double, ptr %w25, i64 %.208418427.i.i
  %.258.i.i = load double, ptr %.257.i.i, align 8
  %.330.i.i = getelementptr i64, ptr %w27, i64 %.208418427.i.i
  %.331.i.i = load i64, ptr %.330.i.i, align 8
  %.362.i.i = getelementptr double, ptr %w25, i64 %at.2.1.i.i
  store double %.258.i.i, ptr %.362.i.i, align 8
  %.394.i.i = getelementptr i64, ptr %w27, i64 %at.2.1.i.i
  store i64 %.331.i.i, ptr %.394.i.i, align 8
  %.447.not.i.i = icmp eq i64 %.208418427.i.i, 0
  br i1 %.447.not.i.i, label %B12.backedge.i, label %B204.else.if.i.i

B204.else.if.i.i:                                 ; preds = %B66.else.if.i.i
  %.458.i.i = add nsw i64 %.208418427.i.i, -1
  %.479424430.i.i = lshr i64 %.458.i.i, 1
  %.528.i.i = getelementptr double, ptr %w25, i64 %.479424430.i.i
  %.529.i.i = load double, ptr %.528.i.i, align 8
  %.531.i.i = fcmp ogt double %.529.i.i, 0.000000e+00
  br i1 %.531.i.i, label %B66.else.if.i.i, label %B12.backedge.i

B12.backedge.i:                                   ; preds = %B204.else.if.i.i, %B66.else.if.i.i, %B20.else.if.i.i, %B14.i
  %at.3.0.i.i = phi i64 [ %size.4.0647.i, %B20.else.if.i.i ], [ 0, %B14.i ], [ 0, %B66.else.if.i.i ], [ %.208418427.i.i, %B204.else.if.i.i ]
  %2 = getelementptr double, ptr %w25, i64 %at.3.0.i.i
  store double 0.000000e+00, ptr %2, align 8
  %3 = getelementptr i64, ptr %w27, i64 %at.3.0.i.i
  store i64 %.213.i, ptr %3, align 8
  %.619.i.i = add nuw nsw i64 %size.4.0647.i, 1
  %exitcond.not.i = icmp eq i64 %.619.i.i, %w32
  br i1 %exitcond.not.i, label %B78.preheader.i, label %B14.i

B78.preheader.i:                                  ; preds = %B12.backedge.i
  %4 = shl i64 %w16, 3
  %factor.op.mul.i.i = shl i64 %w2, 3
  br label %B78.i

B78.i:                                            ; preds = %B226.i, %B78.preheader.i
  %size.5.0.i = phi i64 [ %size.6.1.i, %B226.i ], [ %w32, %B78.preheader.i ]
  %.366.i = load i64, ptr %w27, align 8
  %.79.i.i = add nsw i64 %size.5.0.i, -1
  %.98.i.i = icmp slt i64 %size.5.0.i, 1
  %.99.i.i = select i1 %.98.i.i, i64 %w26, i64 0
  %5 = getelementptr double, ptr %w25, i64 %.79.i.i
  %.113.i.i = getelementptr double, ptr %5, i64 %.99.i.i
  %.114.i.i = load double, ptr %.113.i.i, align 8
  %.131.i.i = select i1 %.98.i.i, i64 %w28, i64 0
  %6 = getelementptr i64, ptr %w27, i64 %.79.i.i
  %.145.i.i = getelementptr i64, ptr %6, i64 %.131.i.i
  %.146.i.i = load i64, ptr %.145.i.i, align 8
  %.162.i.i = icmp sgt i64 %size.5.0.i, 2
  br i1 %.162.i.i, label %B94.i.i, label %B78.endif.i

B94.i.i:                                          ; preds = %B78.i, %B236.i.i
  %at.2.0.i.i = phi i64 [ %child.2.1.i.i, %B236.i.i ], [ 0, %B78.i ]
  %.170.i.i = shl nsw i64 %at.2.0.i.i, 1
  %.171.i.i = or disjoint i64 %.170.i.i, 1
  %.180.i.i = add nsw i64 %.170.i.i, 2
  %.182.i.i = icmp slt i64 %.180.i.i, %.79.i.i
  br i1 %.182.i.i, label %B128.i.i, label %B200.i.i

B128.i.i:                                         ; preds = %B94.i.i
  %.203.i.i = icmp slt i64 %at.2.0.i.i, -1
  %.204.i.i = select i1 %.203.i.i, i64 %w26, i64 0
  %7 = getelementptr double, ptr %w25, i64 %.180.i.i
  %.218.i.i = getelementptr double, ptr %7, i64 %.204.i.i
  %.219.i.i = load double, ptr %.218.i.i, align 8
  %.235.i.i = icmp slt i64 %at.2.0.i.i, 0
  %.236.i.i = select i1 %.235.i.i, i64 %w26, i64 0
  %8 = getelementptr double, ptr %w25, i64 %.171.i.i
  %.250.i.i = getelementptr double, ptr %8, i64 %.236.i.i
  %.251.i.i = load double, ptr %.250.i.i, align 8
  %.252.i.i = fcmp olt double %.219.i.i, %.251.i.i
  br i1 %.252.i.i, label %B190.i.i, label %B200.i.i

B190.i.i:                                         ; preds = %B128.i.i
  br label %B200.i.i

B200.i.i:                                         ; preds = %B190.i.i, %B128.i.i, %B94.i.i
  %child.2.1.i.i = phi i64 [ %.180.i.i, %B190.i.i ], [ %.171.i.i, %B128.i.i ], [ %.171.i.i, %B94.i.i ]
  %.278.i.i = icmp slt i64 %child.2.1.i.i, 0
  %.279.i.i = select i1 %.278.i.i, i64 %w26, i64 0
  %9 = getelementptr double, ptr %w25, i64 %child.2.1.i.i
  %.293.i.i = getelementptr double, ptr %9, i64 %.279.i.i
  %.294.i.i = load double, ptr %.293.i.i, align 8
  %.296.i.i = fcmp ult double %.294.i.i, %.114.i.i
  br i1 %.296.i.i, label %B236.i.i, label %B78.endif.i

B236.i.i:                                         ; preds = %B200.i.i
  %.354.i.i = select i1 %.278.i.i, i64 %w28, i64 0
  %10 = getelementptr i64, ptr %w27, i64 %child.2.1.i.i
  %.368.i.i = getelementptr i64, ptr %10, i64 %.354.i.i
  %.369.i.i = load i64, ptr %.368.i.i, align 8
  %.385.i.i = icmp slt i64 %at.2.0.i.i, 0
  %.386.i.i = select i1 %.385.i.i, i64 %w26, i64 0
  %11 = getelementptr double, ptr %w25, i64 %at.2.0.i.i
  %.400.i.i = getelementptr double, ptr %11, i64 %.386.i.i
  store double %.294.i.i, ptr %.400.i.i, align 8
  %.418.i.i = select i1 %.385.i.i, i64 %w28, i64 0
  %12 = getelementptr i64, ptr %w27, i64 %at.2.0.i.i
  %.432.i.i = getelementptr i64, ptr %12, i64 %.418.i.i
  store i64 %.369.i.i, ptr %.432.i.i, align 8
  %.441.i.i = shl nsw i64 %child.2.1.i.i, 1
  %.442.i.i = or disjoint i64 %.441.i.i, 1
  %.444.i.i = icmp slt i64 %.442.i.i, %.79.i.i
  br i1 %.444.i.i, label %B94.i.i, label %B78.endif.i

B170.i:                                           ; preds = %B78.endif.i
  %sunkaddr.i = shl i64 %.438.i, 3
  %sunkaddr36.i = getelementptr inbounds i8, ptr %31, i64 %sunkaddr.i
  store i64 1, ptr %sunkaddr36.i, align 8
  %.184.i.i = select i1 %.437.i, i64 %w9, i64 0
  %13 = getelementptr i64, ptr %w8, i64 %.366.i
  %.198.i.i = getelementptr i64, ptr %13, i64 %.184.i.i
  %.199.i.i = load i64, ptr %.198.i.i, align 8
  %.216.i.i = icmp slt i64 %.366.i, -1
  %.217.i.i = select i1 %.216.i.i, i64 %w9, i64 0
  %14 = getelementptr i8, ptr %13, i64 8
  %.231.i.i = getelementptr i64, ptr %14, i64 %.217.i.i
  %.232.i.i = load i64, ptr %.231.i.i, align 8
  %.269.i.i = sub i64 %.232.i.i, %.199.i.i
  %.314785.not.i.i = icmp slt i64 %.269.i.i, 1
  br i1 %.314785.not.i.i, label %B226.i, label %B130.endif.endif.us.preheader.i.i

B130.endif.endif.us.preheader.i.i:                ; preds = %B170.i
  %15 = getelementptr double, ptr %w15, i64 %.366.i
  %.99.i.i.i = select i1 %.437.i, i64 %w1, i64 0
  %.100.i.i.i = add i64 %.99.i.i.i, %.366.i
  %sunkaddr.i.i = select i1 %.437.i, i64 %4, i64 0
  %sunkaddr37.i = getelementptr inbounds i8, ptr %15, i64 %sunkaddr.i.i
  %sunkaddr38.i = mul i64 %factor.op.mul.i.i, %.100.i.i.i
  %sunkaddr39.i = getelementptr i8, ptr %w0, i64 %sunkaddr38.i
  %sunkaddr40.i = getelementptr i8, ptr %sunkaddr39.i, i64 16
  %sunkaddr45.i = getelementptr i8, ptr %sunkaddr39.i, i64 8
  br label %B130.endif.endif.us.i.i

B130.endif.endif.us.i.i:                          ; preds = %B188.B128.loopexit_crit_edge.us.i.i, %B130.endif.endif.us.preheader.i.i
  %size.3.0788.us.i.i = phi i64 [ %size.4.2.us.i.i, %B188.B128.loopexit_crit_edge.us.i.i ], [ %.79.i.i, %B130.endif.endif.us.preheader.i.i ]
  %.313775787.us.i.i = phi i64 [ %.323.us.i.i, %B188.B128.loopexit_crit_edge.us.i.i ], [ %.269.i.i, %B130.endif.endif.us.preheader.i.i ]
  %.320778786.us.i.i = phi i64 [ %.327.us.i.i, %B188.B128.loopexit_crit_edge.us.i.i ], [ %.199.i.i, %B130.endif.endif.us.preheader.i.i ]
  %.372.us.i.i = icmp slt i64 %.320778786.us.i.i, 0
  %.373.us.i.i = select i1 %.372.us.i.i, i64 %w11, i64 0
  %16 = getelementptr i64, ptr %w10, i64 %.320778786.us.i.i
  %.387.us.i.i = getelementptr i64, ptr %16, i64 %.373.us.i.i
  %.388.us.i.i = load i64, ptr %.387.us.i.i, align 8
  %.532.us.i.i = icmp slt i64 %.388.us.i.i, 0
  %.533.us.i.i = select i1 %.532.us.i.i, i64 %w4, i64 0
  %.534.us.i.i = add i64 %.533.us.i.i, %.388.us.i.i
  %.554.us.i.i = mul i64 %.534.us.i.i, %w5
  %17 = getelementptr i64, ptr %w3, i64 %.554.us.i.i
  %sunkaddr46.i = getelementptr i8, ptr %17, i64 8
  %sunkaddr47.i = getelementptr i8, ptr %17, i64 16
  br label %B190.us.i.i

B190.us.i.i:                                      ; preds = %B599.us.i.i, %B130.endif.endif.us.i.i
  %size.2.1772.us.i.i = phi i64 [ %size.3.0788.us.i.i, %B130.endif.endif.us.i.i ], [ %size.4.2.us.i.i, %B599.us.i.i ]
  %.477766770.us.i.i = phi i64 [ 0, %B130.endif.endif.us.i.i ], [ %.484.us.i.i, %B599.us.i.i ]
  %.484.us.i.i = add nuw nsw i64 %.477766770.us.i.i, 1
  %18 = getelementptr i64, ptr %17, i64 %.477766770.us.i.i
  %.559.us.i.i = load i64, ptr %18, align 8
  %.565.us.i.i = icmp eq i64 %.559.us.i.i, %.366.i
  br i1 %.565.us.i.i, label %B599.us.i.i, label %B226.us.i.i

B226.us.i.i:                                      ; preds = %B190.us.i.i
  %.765.us.i.i = icmp slt i64 %.559.us.i.i, 0
  %.766.us.i.i = select i1 %.765.us.i.i, i64 %w18, i64 0
  %19 = getelementptr i64, ptr %w17, i64 %.559.us.i.i
  %.780.us.i.i = getelementptr i64, ptr %19, i64 %.766.us.i.i
  %.781.us.i.i = load i64, ptr %.780.us.i.i, align 8
  %.782.us.i.i = icmp eq i64 %.781.us.i.i, 1
  %.72.i.i8.i = load double, ptr %sunkaddr40.i, align 8
  br i1 %.782.us.i.i, label %B336.us.i.i, label %B406.endif.us.i.i

B406.endif.us.i.i:                                ; preds = %B226.us.i.i
  %.923.us.i.i = load double, ptr %sunkaddr37.i, align 8
  %.46.i.i.i = select i1 %.765.us.i.i, i64 %w1, i64 0
  %.47.i.i.i = add i64 %.46.i.i.i, %.559.us.i.i
  %.67.i.i.i = mul i64 %.47.i.i.i, %w2
  %20 = getelementptr double, ptr %w0, i64 %.67.i.i.i
  %.71.i.i.i = getelementptr i8, ptr %20, i64 16
  %.72.i.i.i = load double, ptr %.71.i.i.i, align 8
  %.126.i.i.i = fsub double %.72.i.i.i, %.72.i.i8.i
  %.234.i.i.i = fmul double %.126.i.i.i, %.126.i.i.i
  %.287.i.i.i = load double, ptr %20, align 8
  %.340.i.i.i = load double, ptr %sunkaddr39.i, align 8
  %.341.i.i.i = fsub double %.287.i.i.i, %.340.i.i.i
  %.449.i.i.i = fmul double %.341.i.i.i, %.341.i.i.i
  %.501.i.i.i = getelementptr i8, ptr %20, i64 8
  %.502.i.i.i = load double, ptr %.501.i.i.i, align 8
  %.555.i.i.i = load double, ptr %sunkaddr45.i, align 8
  %.556.i.i.i = fsub double %.502.i.i.i, %.555.i.i.i
  %.664.i.i.i = fmul double %.556.i.i.i, %.556.i.i.i
  %.665.i.i.i = fadd double %.449.i.i.i, %.664.i.i.i
  %.666.i.i.i = fadd double %.234.i.i.i, %.665.i.i.i
  %sqrt.i.i = tail call double @llvm.sqrt.f64(double %.666.i.i.i)
  %.958.us.i.i = fadd double %.923.us.i.i, %sqrt.i.i
  br label %B490.us.i.i

B336.us.i.i:                                      ; preds = %B226.us.i.i
  %.630.us.i.i = load i64, ptr %17, align 8
  %.685.us.i.i = load i64, ptr %sunkaddr46.i, align 8
  %.741.us.i.i = load i64, ptr %sunkaddr47.i, align 8
  %21 = add i64 %.559.us.i.i, %.366.i
  %.686.us.i.i = sub i64 %.630.us.i.i, %21
  %.742.us.i.i = add i64 %.686.us.i.i, %.685.us.i.i
  %.746.us.i.i = add i64 %.742.us.i.i, %.741.us.i.i
  %.99.i.i9.i = select i1 %.765.us.i.i, i64 %w1, i64 0
  %.100.i.i10.i = add i64 %.99.i.i9.i, %.559.us.i.i
  %.120.i.i.i = mul i64 %.100.i.i10.i, %w2
  %22 = getelementptr double, ptr %w0, i64 %.120.i.i.i
  %.124.i.i.i = getelementptr i8, ptr %22, i64 16
  %.125.i.i11.i = load double, ptr %.124.i.i.i, align 8
  %.126.i.i12.i = fsub double %.72.i.i8.i, %.125.i.i11.i
  %.234.i.i13.i = fmul double %.126.i.i12.i, %.126.i.i12.i
  %.287.i.i14.i = load double, ptr %sunkaddr39.i, align 8
  %.340.i.i15.i = load double, ptr %22, align 8
  %.341.i.i16.i = fsub double %.287.i.i14.i, %.340.i.i15.i
  %.449.i.i17.i = fmul double %.341.i.i16.i, %.341.i.i16.i
  %.502.i.i19.i = load double, ptr %sunkaddr45.i, align 8
  %.554.i.i.i = getelementptr i8, ptr %22, i64 8
  %.555.i.i20.i = load double, ptr %.554.i.i.i, align 8
  %.556.i.i21.i = fsub double %.502.i.i19.i, %.555.i.i20.i
  %.664.i.i22.i = fmul double %.556.i.i21.i, %.556.i.i21.i
  %.665.i.i23.i = fadd double %.449.i.i17.i, %.664.i.i22.i
  %.666.i.i24.i = fadd double %.234.i.i13.i, %.665.i.i23.i
  %sqrt77.i.i = tail call double @llvm.sqrt.f64(double %.666.i.i24.i)
  %.79.i25.i = fcmp une double %.666.i.i24.i, 0.000000e+00
  br i1 %.79.i25.i, label %B96.endif.endif.endif.endif.i.i, label %B490.us.i.i

B328.i.i:                                         ; preds = %B96.endif.endif.endif.endif.i.i
  %.234.i59.i.i = fmul double %.233.i20.i.i, %.233.i20.i.i
  %.449.i65.i.i = fmul double %.448.i26.i.i, %.448.i26.i.i
  %.664.i74.i.i = fmul double %.663.i35.i.i, %.663.i35.i.i
  %.665.i75.i.i = fadd double %.449.i65.i.i, %.664.i74.i.i
  %.666.i76.i.i = fadd double %.234.i59.i.i, %.665.i75.i.i
  %.183.i29.i = fmul double %.138.i.i, %.138.i.i
  %.184.i30.i = fsub double %.666.i76.i.i, %.183.i29.i
  %.10.i.i.i = fcmp olt double %.184.i30.i, 0.000000e+00
  %.11.i.i.i = select i1 %.10.i.i.i, double 0.000000e+00, double %.184.i30.i
  %sqrt78.i.i = tail call double @llvm.sqrt.f64(double %.11.i.i.i)
  %.269.i31.i = tail call double @sqrt(double %.248.i.i)
  %.277.i.i = fadd double %sqrt78.i.i, %.269.i31.i
  %.279.i32.i = fcmp ogt double %.277.i.i, 0.000000e+00
  br i1 %.279.i32.i, label %B412.i.i, label %B490.us.i.i

B412.i.i:                                         ; preds = %B328.i.i
  %.283.i.i = fsub double %.138.i.i, %.236.i28.i
  %.285.i.i = fmul double %.283.i.i, %.269.i31.i
  %.292.i.i = fdiv double %.285.i.i, %.277.i.i
  %.294.i33.i = fadd double %.236.i28.i, %.292.i.i
  %.306.i.i = fcmp oge double %.294.i33.i, 0.000000e+00
  %.313.i.i = fcmp ole double %.294.i33.i, %sqrt77.i.i
  %or.cond.i.i = and i1 %.306.i.i, %.313.i.i
  br i1 %or.cond.i.i, label %B446.i.i, label %B490.us.i.i

B446.i.i:                                         ; preds = %B412.i.i
  %.343.i.i = fmul double %.283.i.i, %.283.i.i
  %.354.i34.i = fmul double %.277.i.i, %.277.i.i
  %.355.i.i = fadd double %.343.i.i, %.354.i34.i
  %sqrt.i35.i = tail call double @llvm.sqrt.f64(double %.355.i.i)
  br label %B490.us.i.i

B96.endif.endif.endif.endif.i.i:                  ; preds = %B336.us.i.i
  %.846.us.i.i = load double, ptr %sunkaddr37.i, align 8
  %23 = getelementptr double, ptr %w15, i64 %.559.us.i.i
  %.800.us.i.i = select i1 %.765.us.i.i, i64 %w16, i64 0
  %.814.us.i.i = getelementptr double, ptr %23, i64 %.800.us.i.i
  %.815.us.i.i = load double, ptr %.814.us.i.i, align 8
  %.152.i14.i.i = icmp slt i64 %.746.us.i.i, 0
  %.153.i15.i.i = select i1 %.152.i14.i.i, i64 %w1, i64 0
  %.154.i16.i.i = add i64 %.153.i15.i.i, %.746.us.i.i
  %.174.i17.i.i = mul i64 %.154.i16.i.i, %w2
  %24 = getelementptr double, ptr %w0, i64 %.174.i17.i.i
  %.178.i18.i.i = getelementptr i8, ptr %24, i64 16
  %.179.i19.i.i = load double, ptr %.178.i18.i.i, align 8
  %.233.i20.i.i = fsub double %.179.i19.i.i, %.125.i.i11.i
  %.234.i21.i.i = fmul double %.126.i.i12.i, %.233.i20.i.i
  %.394.i25.i.i = load double, ptr %24, align 8
  %.448.i26.i.i = fsub double %.394.i25.i.i, %.340.i.i15.i
  %.449.i27.i.i = fmul double %.341.i.i16.i, %.448.i26.i.i
  %.608.i33.i.i = getelementptr i8, ptr %24, i64 8
  %.609.i34.i.i = load double, ptr %.608.i33.i.i, align 8
  %.663.i35.i.i = fsub double %.609.i34.i.i, %.555.i.i20.i
  %.664.i36.i.i = fmul double %.556.i.i21.i, %.663.i35.i.i
  %.665.i37.i.i = fadd double %.449.i27.i.i, %.664.i36.i.i
  %.666.i38.i.i = fadd double %.234.i21.i.i, %.665.i37.i.i
  %.138.i.i = fdiv double %.666.i38.i.i, %sqrt77.i.i
  %.219.i26.i = fmul double %.815.us.i.i, %.815.us.i.i
  %.222.i.i = fmul double %.846.us.i.i, %.846.us.i.i
  %.225.i.i = fsub double %.219.i26.i, %.222.i.i
  %.227.i.i = fadd double %.666.i.i24.i, %.225.i.i
  %.232.i27.i = fmul double %sqrt77.i.i, 2.000000e+00
  %.236.i28.i = fdiv double %.227.i.i, %.232.i27.i
  %.247.i.i = fmul double %.236.i28.i, %.236.i28.i
  %.248.i.i = fsub double %.219.i26.i, %.247.i.i
  %.254.i.i = fcmp olt double %.248.i.i, 0.000000e+00
  br i1 %.254.i.i, label %B490.us.i.i, label %B328.i.i

B490.us.i.i:                                      ; preds = %B96.endif.endif.endif.endif.i.i, %B446.i.i, %B412.i.i, %B328.i.i, %B336.us.i.i, %B406.endif.us.i.i
  %away.2.3.us.i.i = phi double [ %.958.us.i.i, %B406.endif.us.i.i ], [ 0x7FF0000000000000, %B96.endif.endif.endif.endif.i.i ], [ 0x7FF0000000000000, %B336.us.i.i ], [ %sqrt.i35.i, %B446.i.i ], [ 0x7FF0000000000000, %B412.i.i ], [ 0x7FF0000000000000, %B328.i.i ]
  %target.2.3.us.i.i = phi i64 [ %.559.us.i.i, %B406.endif.us.i.i ], [ %.746.us.i.i, %B96.endif.endif.endif.endif.i.i ], [ %.746.us.i.i, %B336.us.i.i ], [ %.746.us.i.i, %B446.i.i ], [ %.746.us.i.i, %B412.i.i ], [ %.746.us.i.i, %B328.i.i ]
  %.986.us.i.i = icmp slt i64 %target.2.3.us.i.i, 0
  %.987.us.i.i = select i1 %.986.us.i.i, i64 %w18, i64 0
  %25 = getelementptr i64, ptr %w17, i64 %target.2.3.us.i.i
  %.1001.us.i.i = getelementptr i64, ptr %25, i64 %.987.us.i.i
  %.1002.us.i.i = load i64, ptr %.1001.us.i.i, align 8
  %.1003.not.us.i.i = icmp eq i64 %.1002.us.i.i, 1
  br i1 %.1003.not.us.i.i, label %B599.us.i.i, label %B524.us.i.i

B524.us.i.i:                                      ; preds = %B490.us.i.i
  %.1023.us.i.i = select i1 %.986.us.i.i, i64 %w16, i64 0
  %26 = getelementptr double, ptr %w15, i64 %target.2.3.us.i.i
  %.1037.us.i.i = getelementptr double, ptr %26, i64 %.1023.us.i.i
  %.1038.us.i.i = load double, ptr %.1037.us.i.i, align 8
  %.1040.us.i.i = fcmp olt double %away.2.3.us.i.i, %.1038.us.i.i
  br i1 %.1040.us.i.i, label %B548.us.i.i, label %B599.us.i.i

B548.us.i.i:                                      ; preds = %B524.us.i.i
  %sunkaddr17.i.i = shl i64 %.1023.us.i.i, 3
  %sunkaddr18.i.i = getelementptr inbounds i8, ptr %26, i64 %sunkaddr17.i.i
  store double %away.2.3.us.i.i, ptr %sunkaddr18.i.i, align 8
  %.96.i.i.i = icmp sgt i64 %size.2.1772.us.i.i, 0
  br i1 %.96.i.i.i, label %B20.else.if.i.i.i, label %_ZN7msf_jax4host4thin6fronts4pushB3v39B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx.exit.i.i

B20.else.if.i.i.i:                                ; preds = %B548.us.i.i
  %.108.i.i.i = add nsw i64 %size.2.1772.us.i.i, -1
  %.129416426.i.i.i = lshr i64 %.108.i.i.i, 1
  %.178.i1.i.i = getelementptr double, ptr %w25, i64 %.129416426.i.i.i
  %.179.i2.i.i = load double, ptr %.178.i1.i.i, align 8
  %.181.i.i.i = fcmp ogt double %.179.i2.i.i, %away.2.3.us.i.i
  br i1 %.181.i.i.i, label %B66.else.if.i.i.i, label %_ZN7msf_jax4host4thin6fronts4pushB3v39B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx.exit.i.i

B66.else.if.i.i.i:                                ; preds = %B20.else.if.i.i.i, %B204.else.if.i.i.i
  %at.2.1.i.i.i = phi i64 [ %.208418427.i.i.i, %B204.else.if.i.i.i ], [ %size.2.1772.us.i.i, %B20.else.if.i.i.i ]
  %.189.i.i.i = add nsw i64 %at.2.1.i.i.i, -1
  %.208418427.i.i.i = lshr i64 %.189.i.i.i, 1
  %.257.i.i.i = getelementptr double, ptr %w25, i64 %.208418427.i.i.i
  %.258.i.i.i = load double, ptr %.257.i.i.i, align 8
  %.330.i.i.i = getelementptr i64, ptr %w27, i64 %.208418427.i.i.i
  %.331.i.i.i = load i64, ptr %.330.i.i.i, align 8
  %.362.i.i.i = getelementptr double, ptr %w25, i64 %at.2.1.i.i.i
  store double %.258.i.i.i, ptr %.362.i.i.i, align 8
  %.394.i3.i.i = getelementptr i64, ptr %w27, i64 %at.2.1.i.i.i
  store i64 %.331.i.i.i, ptr %.394.i3.i.i, align 8
  %.447.not.i.i.i = icmp eq i64 %.208418427.i.i.i, 0
  br i1 %.447.not.i.i.i, label %_ZN7msf_jax4host4thin6fronts4pushB3v39B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx.exit.i.i, label %B204.else.if.i.i.i

B204.else.if.i.i.i:                               ; preds = %B66.else.if.i.i.i
  %.458.i.i.i = add nsw i64 %.208418427.i.i.i, -1
  %.479424430.i.i.i = lshr i64 %.458.i.i.i, 1
  %.528.i.i.i = getelementptr double, ptr %w25, i64 %.479424430.i.i.i
  %.529.i.i.i = load double, ptr %.528.i.i.i, align 8
  %.531.i.i.i = fcmp ogt double %.529.i.i.i, %away.2.3.us.i.i
  br i1 %.531.i.i.i, label %B66.else.if.i.i.i, label %_ZN7msf_jax4host4thin6fronts4pushB3v39B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx.exit.i.i

_ZN7msf_jax4host4thin6fronts4pushB3v39B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx.exit.i.i: ; preds = %B204.else.if.i.i.i, %B66.else.if.i.i.i, %B20.else.if.i.i.i, %B548.us.i.i
  %at.3.0.i.i.i = phi i64 [ %size.2.1772.us.i.i, %B20.else.if.i.i.i ], [ %size.2.1772.us.i.i, %B548.us.i.i ], [ 0, %B66.else.if.i.i.i ], [ %.208418427.i.i.i, %B204.else.if.i.i.i ]
  %.560.i.i.i = icmp slt i64 %at.3.0.i.i.i, 0
  %.561.i.i.i = select i1 %.560.i.i.i, i64 %w26, i64 0
  %27 = getelementptr double, ptr %w25, i64 %at.3.0.i.i.i
  %.575.i.i.i = getelementptr double, ptr %27, i64 %.561.i.i.i
  store double %away.2.3.us.i.i, ptr %.575.i.i.i, align 8
  %.598.i.i.i = select i1 %.560.i.i.i, i64 %w28, i64 0
  %28 = getelementptr i64, ptr %w27, i64 %at.3.0.i.i.i
  %.612.i.i.i = getelementptr i64, ptr %28, i64 %.598.i.i.i
  store i64 %target.2.3.us.i.i, ptr %.612.i.i.i, align 8
  %.619.i.i.i = add nsw i64 %size.2.1772.us.i.i, 1
  br label %B599.us.i.i

B599.us.i.i:                                      ; preds = %_ZN7msf_jax4host4thin6fronts4pushB3v39B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx.exit.i.i, %B524.us.i.i, %B490.us.i.i, %B190.us.i.i
  %size.4.2.us.i.i = phi i64 [ %size.2.1772.us.i.i, %B190.us.i.i ], [ %size.2.1772.us.i.i, %B490.us.i.i ], [ %size.2.1772.us.i.i, %B524.us.i.i ], [ %.619.i.i.i, %_ZN7msf_jax4host4thin6fronts4pushB3v39B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx.exit.i.i ]
  %exitcond.not.i.i = icmp eq i64 %.484.us.i.i, 3
  br i1 %exitcond.not.i.i, label %B188.B128.loopexit_crit_edge.us.i.i, label %B190.us.i.i

B188.B128.loopexit_crit_edge.us.i.i:              ; preds = %B599.us.i.i
  %.323.us.i.i = add nsw i64 %.313775787.us.i.i, -1
  %.327.us.i.i = add i64 %.320778786.us.i.i, 1
  %.314.us.i.i = icmp sgt i64 %.313775787.us.i.i, 1
  br i1 %.314.us.i.i, label %B130.endif.endif.us.i.i, label %B226.i

B226.i:                                           ; preds = %B188.B128.loopexit_crit_edge.us.i.i, %B78.endif.i, %B170.i
  %size.6.1.i = phi i64 [ %.79.i.i, %B78.endif.i ], [ %.79.i.i, %B170.i ], [ %size.4.2.us.i.i, %B188.B128.loopexit_crit_edge.us.i.i ]
  %.566.not.i = icmp eq i64 %size.6.1.i, 0
  br i1 %.566.not.i, label %_ZN7msf_jax4host4thin6fronts6spreadB3v33B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE.exit, label %B78.i

B78.endif.i:                                      ; preds = %B236.i.i, %B200.i.i, %B78.i
  %at.3.1.i.i = phi i64 [ 0, %B78.i ], [ %child.2.1.i.i, %B236.i.i ], [ %at.2.0.i.i, %B200.i.i ]
  %.469.i.i = icmp slt i64 %at.3.1.i.i, 0
  %.470.i.i = select i1 %.469.i.i, i64 %w26, i64 0
  %29 = getelementptr double, ptr %w25, i64 %at.3.1.i.i
  %.484.i.i = getelementptr double, ptr %29, i64 %.470.i.i
  store double %.114.i.i, ptr %.484.i.i, align 8
  %.507.i.i = select i1 %.469.i.i, i64 %w28, i64 0
  %30 = getelementptr i64, ptr %w27, i64 %at.3.1.i.i
  %.521.i.i = getelementptr i64, ptr %30, i64 %.507.i.i
  store i64 %.146.i.i, ptr %.521.i.i, align 8
  %.437.i = icmp slt i64 %.366.i, 0
  %.438.i = select i1 %.437.i, i64 %w18, i64 0
  %31 = getelementptr i64, ptr %w17, i64 %.366.i
  %.452.i = getelementptr i64, ptr %31, i64 %.438.i
  %.453.i = load i64, ptr %.452.i, align 8
  %.454.not.i = icmp eq i64 %.453.i, 1
  br i1 %.454.not.i, label %B226.i, label %B170.i

_ZN7msf_jax4host4thin6fronts6spreadB3v33B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B226.i, %0
  ret i64 0
}

declare i64 @llvm.smin.i64(i64, i64)

declare void @llvm.lifetime.start.p0(ptr)

declare void @llvm.lifetime.end.p0(ptr)

declare void @llvm.memset.p0.i64(ptr writeonly, i8, i64, i1 immarg)

declare { i8, i1 } @llvm.usub.with.overflow.i8(i8, i8)

define i64 @msf_jax.host.thin.fronts.cap(ptr readonly %words) local_unnamed_addr {
  %w0 = load ptr, ptr %words, align 8
  %p1 = getelementptr i8, ptr %words, i64 8
  %w1 = load i64, ptr %p1, align 8
  %p2 = getelementptr i8, ptr %words, i64 16
  %w2 = load i64, ptr %p2, align 8
  %s3 = shl i64 %w2, 3
  %p3 = getelementptr i8, ptr %words, i64 24
  %w3 = load ptr, ptr %p3, align 8
  %p4 = getelementptr i8, ptr %words, i64 32
  %w4 = load i64, ptr %p4, align 8
  %p5 = getelementptr i8, ptr %words, i64 40
  %w5 = load i64, ptr %p5, align 8
  %p6 = getelementptr i8, ptr %words, i64 48
  %w6 = load ptr, ptr %p6, align 8
  %p7 = getelementptr i8, ptr %words, i64 56
  %w7 = load i64, ptr %p7, align 8
  %p8 = getelementptr i8, ptr %words, i64 64
  %w8 = load ptr, ptr %p8, align 8
  %p9 = getelementptr i8, ptr %words, i64 72
  %w9 = load i64, ptr %p9, align 8
  %p10 = getelementptr i8, ptr %words, i64 80
  %w10 = load ptr, ptr %p10, align 8
  %p11 = getelementptr i8, ptr %words, i64 88
  %w11 = load i64, ptr %p11, align 8
  %p12 = getelementptr i8, ptr %words, i64 96
  %w12 = load ptr, ptr %p12, align 8
  %p13 = getelementptr i8, ptr %words, i64 104
  %w13 = load i64, ptr %p13, align 8
  %p14 = getelementptr i8, ptr %words, i64 112
  %w14 = load i64, ptr %p14, align 8
  %p15 = getelementptr i8, ptr %words, i64 120
  %w15 = load ptr, ptr %p15, align 8
  %p16 = getelementptr i8, ptr %words, i64 128
  %w16 = load i64, ptr %p16, align 8
  %p17 = getelementptr i8, ptr %words, i64 136
  %w17 = load ptr, ptr %p17, align 8
  %p18 = getelementptr i8, ptr %words, i64 144
  %w18 = load i64, ptr %p18, align 8
  %p19 = getelementptr i8, ptr %words, i64 152
  %w19 = load ptr, ptr %p19, align 8
  %p20 = getelementptr i8, ptr %words, i64 160
  %w20 = load i64, ptr %p20, align 8
  %p21 = getelementptr i8, ptr %words, i64 168
  %w21 = load ptr, ptr %p21, align 8
  %p22 = getelementptr i8, ptr %words, i64 176
  %w22 = load i64, ptr %p22, align 8
  %p23 = getelementptr i8, ptr %words, i64 184
  %w23 = load ptr, ptr %p23, align 8
  %p24 = getelementptr i8, ptr %words, i64 192
  %w24 = load i64, ptr %p24, align 8
  %p25 = getelementptr i8, ptr %words, i64 200
  %w25 = load ptr, ptr %p25, align 8
  %p26 = getelementptr i8, ptr %words, i64 208
  %w26 = load i64, ptr %p26, align 8
  %p27 = getelementptr i8, ptr %words, i64 216
  %w27 = load ptr, ptr %p27, align 8
  %p28 = getelementptr i8, ptr %words, i64 224
  %w28 = load i64, ptr %p28, align 8
  %p29 = getelementptr i8, ptr %words, i64 232
  %w29 = load ptr, ptr %p29, align 8
  %p30 = getelementptr i8, ptr %words, i64 240
  %w30 = load i64, ptr %p30, align 8
  %p31 = getelementptr i8, ptr %words, i64 248
  %w31 = load i64, ptr %p31, align 8
  %p32 = getelementptr i8, ptr %words, i64 256
  %w32 = load double, ptr %p32, align 8
  %p33 = getelementptr i8, ptr %words, i64 264
  %w33 = load double, ptr %p33, align 8
  %p34 = getelementptr i8, ptr %words, i64 272
  %w34 = load double, ptr %p34, align 8
  %p35 = getelementptr i8, ptr %words, i64 280
  %w35 = load double, ptr %p35, align 8
  %p36 = getelementptr i8, ptr %words, i64 288
  %w36 = load double, ptr %p36, align 8
  %p37 = getelementptr i8, ptr %words, i64 296
  %w37 = load ptr, ptr %p37, align 8
  %p38 = getelementptr i8, ptr %words, i64 304
  %w38 = load i64, ptr %p38, align 8
  %p39 = getelementptr i8, ptr %words, i64 312
  %w39 = load ptr, ptr %p39, align 8
  %p40 = getelementptr i8, ptr %words, i64 320
  %w40 = load i64, ptr %p40, align 8
  %p41 = getelementptr i8, ptr %words, i64 328
  %w41 = load i64, ptr %p41, align 8
  %s60 = shl i64 %w41, 3
  %p42 = getelementptr i8, ptr %words, i64 336
  %w42 = load ptr, ptr %p42, align 8
  %p43 = getelementptr i8, ptr %words, i64 344
  %w43 = load i64, ptr %p43, align 8
  %.241.i = add nsw i64 %w40, -1
  %.261.i = tail call i64 @llvm.smin.i64(i64 %w40, i64 0)
  %.262.i = add i64 %.241.i, %.261.i
  %.279.i = mul i64 %.262.i, %w41
  %.281.i = getelementptr double, ptr %w39, i64 %.279.i
  %.323.i = add i64 %w40, 2305843009213693950
  %.342.i = icmp slt i64 %w40, 2
  %.343.i = select i1 %.342.i, i64 %w40, i64 0
  %.344.i = add i64 %.323.i, %.343.i
  %.411.i = add nsw i64 %w40, -3
  %.430.i = icmp slt i64 %w40, 3
  %.431.i = select i1 %.430.i, i64 %w40, i64 0
  %.432.i = add i64 %.411.i, %.431.i
  %.449.i = mul i64 %.432.i, %w41
  %.451.i = getelementptr double, ptr %w39, i64 %.449.i
  %.493.i = add nsw i64 %w40, -4
  %.512.i = icmp slt i64 %w40, 4
  %.513.i = select i1 %.512.i, i64 %w40, i64 0
  %.514.i = add i64 %.513.i, %.493.i
  %.531.i = mul i64 %.514.i, %w41
  %.533.i = getelementptr double, ptr %w39, i64 %.531.i
  %.583.i = icmp slt i64 %w31, 0
  %.584.i = select i1 %.583.i, i64 %w16, i64 0
  %1 = getelementptr double, ptr %w15, i64 %w31
  %.598.i = getelementptr double, ptr %1, i64 %.584.i
  store double 0.000000e+00, ptr %.598.i, align 8
  store double 0.000000e+00, ptr %w25, align 8
  store i64 %w31, ptr %w27, align 8
  %2 = shl i64 %w16, 3
  %scevgep250.i = getelementptr i8, ptr %w42, i64 24
  %factor.op.mul.reass.i = mul i64 %s60, %.344.i
  %sunkaddr373.i = getelementptr i8, ptr %w39, i64 %factor.op.mul.reass.i
  %3 = shl i64 %w11, 3
  %sunkaddr374.i = getelementptr i8, ptr %.533.i, i64 8
  %sunkaddr375.i = getelementptr i8, ptr %.533.i, i64 16
  %sunkaddr376.i = getelementptr i8, ptr %.533.i, i64 24
  %sunkaddr377.i = getelementptr i8, ptr %.533.i, i64 32
  %sunkaddr1.i.i = getelementptr i8, ptr %.281.i, i64 8
  %sunkaddr.i36.i = getelementptr i8, ptr %.281.i, i64 16
  %sunkaddr2.i.i = getelementptr i8, ptr %.281.i, i64 24
  %sunkaddr3.i.i = getelementptr i8, ptr %.281.i, i64 32
  %sunkaddr4.i.i = getelementptr i8, ptr %.281.i, i64 40
  %sunkaddr5.i.i = getelementptr i8, ptr %.281.i, i64 48
  %sunkaddr6.i.i = getelementptr i8, ptr %.281.i, i64 56
  %sunkaddr7.i.i = getelementptr i8, ptr %.281.i, i64 64
  %sunkaddr385.i = getelementptr i8, ptr %sunkaddr373.i, i64 8
  %sunkaddr389.i = getelementptr i8, ptr %sunkaddr373.i, i64 16
  %sunkaddr393.i = getelementptr i8, ptr %sunkaddr373.i, i64 24
  %sunkaddr83.i.i = getelementptr i8, ptr %.451.i, i64 8
  %sunkaddr84.i.i = getelementptr i8, ptr %.451.i, i64 16
  %sunkaddr85.i.i = getelementptr i8, ptr %.451.i, i64 24
  %sunkaddr86.i.i = getelementptr i8, ptr %.451.i, i64 32
  br label %B316.preheader.i

B316.preheader.i:                                 ; preds = %B568.i, %0
  %size.3.03910.i = phi i64 [ 1, %0 ], [ %size.4.1.i, %B568.i ]
  %slenderest.6.03909.i = phi double [ 0xFFF0000000000000, %0 ], [ %.us-phi3608.i, %B568.i ]
  %last.5.03908.i = phi double [ 0x7FF0000000000000, %0 ], [ %.us-phi3607.i, %B568.i ]
  %size_of_region.3.03907.i = phi i64 [ 0, %0 ], [ %.us-phi3606.i, %B568.i ]
  %count.2.03906.i = phi i64 [ 0, %0 ], [ %count.3.1.i, %B568.i ]
  %rows.5.03905.i = phi i64 [ 0, %0 ], [ %.us-phi3605.i, %B568.i ]
  %level.3.03904.i = phi double [ %w32, %0 ], [ %.us-phi3604.i, %B568.i ]
  %.1146.i = icmp sgt i64 %count.2.03906.i, 5
  br i1 %.1146.i, label %B316.preheader3975.i, label %B316.preheader.split.us.split.i

B316.preheader3975.i:                             ; preds = %B316.preheader.i
  %xtraiter143.i = and i64 %count.2.03906.i, 3
  %unroll_iter146.i = and i64 %count.2.03906.i, 9223372036854775804
  %4 = shl i64 %count.2.03906.i, 3
  %scevgep251.i = getelementptr i8, ptr %scevgep250.i, i64 %4
  %scevgep259.i = getelementptr i8, ptr %w42, i64 %4
  %5 = icmp eq i64 %xtraiter143.i, 0
  br label %B316.i

B316.preheader.split.us.split.i:                  ; preds = %B316.preheader.i
  %.775.us.i = load double, ptr %w25, align 8
  %.780.us3640.i = fcmp olt double %.775.us.i, %level.3.03904.i
  br i1 %.780.us3640.i, label %B380.i, label %B570.us.i

B570.us.i:                                        ; preds = %B316.preheader.split.us.split.i, %B570.us.i
  %level.2.2.us3641.i = phi double [ %.5543.us.i, %B570.us.i ], [ %level.3.03904.i, %B316.preheader.split.us.split.i ]
  %.5543.us.i = fmul double %w33, %level.2.2.us3641.i
  %.780.us.i = fcmp olt double %.775.us.i, %.5543.us.i
  br i1 %.780.us.i, label %B380.i, label %B570.us.i

B316.i:                                           ; preds = %B2584.i, %B316.preheader3975.i
  %level.2.2.i = phi double [ %.5543.i, %B2584.i ], [ %level.3.03904.i, %B316.preheader3975.i ]
  %rows.2.2.i = phi i64 [ %rows.3.3.i, %B2584.i ], [ %rows.5.03905.i, %B316.preheader3975.i ]
  %size_of_region.4.2.i = phi i64 [ %size_of_region.5.3.i, %B2584.i ], [ %size_of_region.3.03907.i, %B316.preheader3975.i ]
  %last.2.2.i = phi double [ %last.3.3.i, %B2584.i ], [ %last.5.03908.i, %B316.preheader3975.i ]
  %slenderest.2.2.i = phi double [ %slenderest.3.3.i, %B2584.i ], [ %slenderest.6.03909.i, %B316.preheader3975.i ]
  %.775.i = load double, ptr %w25, align 8
  %.780.i = fcmp olt double %.775.i, %level.2.2.i
  br i1 %.780.i, label %B380.i, label %B570.i

B380.i:                                           ; preds = %B570.us.i, %B316.i, %B316.preheader.split.us.split.i
  %.us-phi3604.i = phi double [ %level.2.2.i, %B316.i ], [ %level.3.03904.i, %B316.preheader.split.us.split.i ], [ %.5543.us.i, %B570.us.i ]
  %.us-phi3605.i = phi i64 [ %rows.2.2.i, %B316.i ], [ %rows.5.03905.i, %B316.preheader.split.us.split.i ], [ %rows.5.03905.i, %B570.us.i ]
  %.us-phi3606.i = phi i64 [ %size_of_region.4.2.i, %B316.i ], [ %size_of_region.3.03907.i, %B316.preheader.split.us.split.i ], [ %size_of_region.3.03907.i, %B570.us.i ]
  %.us-phi3607.i = phi double [ %last.2.2.i, %B316.i ], [ %last.5.03908.i, %B316.preheader.split.us.split.i ], [ %last.5.03908.i, %B570.us.i ]
  %.us-phi3608.i = phi double [ %slenderest.2.2.i, %B316.i ], [ %slenderest.6.03909.i, %B316.preheader.split.us.split.i ], [ %slenderest.6.03909.i, %B570.us.i ]
  %.us-phi3609.i = load i64, ptr %w27, align 8
  %.79.i.i = add nsw i64 %size.3.03910.i, -1
  %.98.i.i = icmp slt i64 %size.3.03910.i, 1
  %.99.i.i = select i1 %.98.i.i, i64 %w26, i64 0
  %6 = getelementptr double, ptr %w25, i64 %.79.i.i
  %.113.i.i = getelementptr double, ptr %6, i64 %.99.i.i
  %.114.i.i = load double, ptr %.113.i.i, align 8
  %.131.i.i = select i1 %.98.i.i, i64 %w28, i64 0
  %7 = getelementptr i64, ptr %w27, i64 %.79.i.i
  %.145.i.i = getelementptr i64, ptr %7, i64 %.131.i.i
  %.146.i.i = load i64, ptr %.145.i.i, align 8
  %.162.i.i = icmp sgt i64 %size.3.03910.i, 2
  br i1 %.162.i.i, label %B94.i.i, label %B380.endif.i

B94.i.i:                                          ; preds = %B380.i, %B236.i.i
  %at.2.0.i.i = phi i64 [ %child.2.1.i.i, %B236.i.i ], [ 0, %B380.i ]
  %.170.i.i = shl nsw i64 %at.2.0.i.i, 1
  %.171.i.i = or disjoint i64 %.170.i.i, 1
  %.180.i.i = add nsw i64 %.170.i.i, 2
  %.182.i.i = icmp slt i64 %.180.i.i, %.79.i.i
  br i1 %.182.i.i, label %B128.i.i, label %B200.i.i

B128.i.i:                                         ; preds = %B94.i.i
  %.203.i.i = icmp slt i64 %at.2.0.i.i, -1
  %.204.i.i = select i1 %.203.i.i, i64 %w26, i64 0
  %8 = getelementptr double, ptr %w25, i64 %.180.i.i
  %.218.i.i = getelementptr double, ptr %8, i64 %.204.i.i
  %.219.i.i = load double, ptr %.218.i.i, align 8
  %.235.i.i = icmp slt i64 %at.2.0.i.i, 0
  %.236.i.i = select i1 %.235.i.i, i64 %w26, i64 0
  %9 = getelementptr double, ptr %w25, i64 %.171.i.i
  %.250.i.i = getelementptr double, ptr %9, i64 %.236.i.i
  %.251.i.i = load double, ptr %.250.i.i, align 8
  %.252.i.i = fcmp olt double %.219.i.i, %.251.i.i
  br i1 %.252.i.i, label %B190.i.i, label %B200.i.i

B190.i.i:                                         ; preds = %B128.i.i
  br label %B200.i.i

B200.i.i:                                         ; preds = %B190.i.i, %B128.i.i, %B94.i.i
  %child.2.1.i.i = phi i64 [ %.180.i.i, %B190.i.i ], [ %.171.i.i, %B128.i.i ], [ %.171.i.i, %B94.i.i ]
  %.278.i.i = icmp slt i64 %child.2.1.i.i, 0
  %.279.i.i = select i1 %.278.i.i, i64 %w26, i64 0
  %10 = getelementptr double, ptr %w25, i64 %child.2.1.i.i
  %.293.i.i = getelementptr double, ptr %10, i64 %.279.i.i
  %.294.i.i = load double, ptr %.293.i.i, align 8
  %.296.i.i = fcmp ult double %.294.i.i, %.114.i.i
  br i1 %.296.i.i, label %B236.i.i, label %B380.endif.i

B236.i.i:                                         ; preds = %B200.i.i
  %.354.i.i = select i1 %.278.i.i, i64 %w28, i64 0
  %11 = getelementptr i64, ptr %w27, i64 %child.2.1.i.i
  %.368.i.i = getelementptr i64, ptr %11, i64 %.354.i.i
  %.369.i.i = load i64, ptr %.368.i.i, align 8
  %.385.i.i = icmp slt i64 %at.2.0.i.i, 0
  %.386.i.i = select i1 %.385.i.i, i64 %w26, i64 0
  %12 = getelementptr double, ptr %w25, i64 %at.2.0.i.i
  %.400.i.i = getelementptr double, ptr %12, i64 %.386.i.i
  store double %.294.i.i, ptr %.400.i.i, align 8
  %.418.i.i = select i1 %.385.i.i, i64 %w28, i64 0
  %13 = getelementptr i64, ptr %w27, i64 %at.2.0.i.i
  %.432.i.i = getelementptr i64, ptr %13, i64 %.418.i.i
  store i64 %.369.i.i, ptr %.432.i.i, align 8
  %.441.i.i = shl nsw i64 %child.2.1.i.i, 1
  %.442.i.i = or disjoint i64 %.441.i.i, 1
  %.444.i.i = icmp slt i64 %.442.i.i, %.79.i.i
  br i1 %.444.i.i, label %B94.i.i, label %B380.endif.i

B446.i:                                           ; preds = %B380.endif.i
  %sunkaddr.i = shl i64 %.860.i, 3
  %sunkaddr274.i = getelementptr inbounds i8, ptr %158, i64 %sunkaddr.i
  store i64 1, ptr %sunkaddr274.i, align 8
  %.932.i = icmp slt i64 %count.2.03906.i, 0
  %.933.i = select i1 %.932.i, i64 %w20, i64 0
  %14 = getelementptr i64, ptr %w19, i64 %count.2.03906.i
  %.947.i = getelementptr i64, ptr %14, i64 %.933.i
  store i64 %.us-phi3609.i, ptr %.947.i, align 8
  %.950.i = add i64 %count.2.03906.i, 1
  %.958.i = icmp eq i64 %.us-phi3609.i, %w31
  br i1 %.958.i, label %B530.i, label %B508.i

B508.i:                                           ; preds = %B446.i
  %.978.i = select i1 %.859.i, i64 %w38, i64 0
  %15 = getelementptr i64, ptr %w37, i64 %.us-phi3609.i
  %.992.i = getelementptr i64, ptr %15, i64 %.978.i
  %.993.i = load i64, ptr %.992.i, align 8
  %.994.i = icmp eq i64 %.993.i, 0
  br label %B530.i

B530.i:                                           ; preds = %B508.i, %B446.i
  %"$phi530.0.2.1.i" = phi i1 [ true, %B446.i ], [ %.994.i, %B508.i ]
  %.184.i.i = select i1 %.859.i, i64 %w9, i64 0
  %16 = getelementptr i64, ptr %w8, i64 %.us-phi3609.i
  %.198.i.i = getelementptr i64, ptr %16, i64 %.184.i.i
  %.199.i.i = load i64, ptr %.198.i.i, align 8
  %.216.i.i = icmp slt i64 %.us-phi3609.i, -1
  %.217.i.i = select i1 %.216.i.i, i64 %w9, i64 0
  %17 = getelementptr i8, ptr %16, i64 8
  %.231.i.i = getelementptr i64, ptr %17, i64 %.217.i.i
  %.232.i.i = load i64, ptr %.231.i.i, align 8
  %.269.i.i = sub i64 %.232.i.i, %.199.i.i
  %.314785.not.i.i = icmp slt i64 %.269.i.i, 1
  br i1 %.314785.not.i.i, label %B568.i, label %B130.endif.endif.us.preheader.i.i

B130.endif.endif.us.preheader.i.i:                ; preds = %B530.i
  %18 = getelementptr double, ptr %w15, i64 %.us-phi3609.i
  %.99.i.i.i = select i1 %.859.i, i64 %w1, i64 0
  %.100.i.i.i = add i64 %.99.i.i.i, %.us-phi3609.i
  %sunkaddr.i.i = select i1 %.859.i, i64 %2, i64 0
  %.120.i.reass.i.i = mul i64 %s3, %.100.i.i.i
  %sunkaddr275.i = getelementptr inbounds i8, ptr %18, i64 %sunkaddr.i.i
  %sunkaddr276.i = getelementptr i8, ptr %w0, i64 %.120.i.reass.i.i
  %sunkaddr277.i = getelementptr i8, ptr %sunkaddr276.i, i64 16
  %sunkaddr280.i = getelementptr i8, ptr %sunkaddr276.i, i64 8
  %.67.i.i3.i = mul i64 %.100.i.i.i, %w2
  %19 = getelementptr double, ptr %w0, i64 %.67.i.i3.i
  %.71.i.i4.i = getelementptr i8, ptr %19, i64 16
  %.501.i.i15.i = getelementptr i8, ptr %19, i64 8
  br label %B130.endif.endif.us.i.i

B130.endif.endif.us.i.i:                          ; preds = %B188.B128.loopexit_crit_edge.us.i.i, %B130.endif.endif.us.preheader.i.i
  %size.3.0788.us.i.i = phi i64 [ %size.4.2.us.i.i, %B188.B128.loopexit_crit_edge.us.i.i ], [ %.79.i.i, %B130.endif.endif.us.preheader.i.i ]
  %.313775787.us.i.i = phi i64 [ %.323.us.i.i, %B188.B128.loopexit_crit_edge.us.i.i ], [ %.269.i.i, %B130.endif.endif.us.preheader.i.i ]
  %.320778786.us.i.i = phi i64 [ %.327.us.i.i, %B188.B128.loopexit_crit_edge.us.i.i ], [ %.199.i.i, %B130.endif.endif.us.preheader.i.i ]
  %.372.us.i.i = icmp slt i64 %.320778786.us.i.i, 0
  %.373.us.i.i = select i1 %.372.us.i.i, i64 %w11, i64 0
  %20 = getelementptr i64, ptr %w10, i64 %.320778786.us.i.i
  %.387.us.i.i = getelementptr i64, ptr %20, i64 %.373.us.i.i
  %.388.us.i.i = load i64, ptr %.387.us.i.i, align 8
  %.532.us.i.i = icmp slt i64 %.388.us.i.i, 0
  %.533.us.i.i = select i1 %.532.us.i.i, i64 %w4, i64 0
  %.534.us.i.i = add i64 %.533.us.i.i, %.388.us.i.i
  %.554.us.i.i = mul i64 %.534.us.i.i, %w5
  %21 = getelementptr i64, ptr %w3, i64 %.554.us.i.i
  %sunkaddr281.i = getelementptr i8, ptr %21, i64 8
  %sunkaddr282.i = getelementptr i8, ptr %21, i64 16
  br label %B190.us.i.i

B190.us.i.i:                                      ; preds = %B599.us.i.i, %B130.endif.endif.us.i.i
  %size.2.1772.us.i.i = phi i64 [ %size.3.0788.us.i.i, %B130.endif.endif.us.i.i ], [ %size.4.2.us.i.i, %B599.us.i.i ]
  %.477766770.us.i.i = phi i64 [ 0, %B130.endif.endif.us.i.i ], [ %.484.us.i.i, %B599.us.i.i ]
  %.484.us.i.i = add nuw nsw i64 %.477766770.us.i.i, 1
  %22 = getelementptr i64, ptr %21, i64 %.477766770.us.i.i
  %.559.us.i.i = load i64, ptr %22, align 8
  %.565.us.i.i = icmp eq i64 %.559.us.i.i, %.us-phi3609.i
  br i1 %.565.us.i.i, label %B599.us.i.i, label %B226.us.i.i

B226.us.i.i:                                      ; preds = %B190.us.i.i
  %.765.us.i.i = icmp slt i64 %.559.us.i.i, 0
  %.766.us.i.i = select i1 %.765.us.i.i, i64 %w18, i64 0
  %23 = getelementptr i64, ptr %w17, i64 %.559.us.i.i
  %.780.us.i.i = getelementptr i64, ptr %23, i64 %.766.us.i.i
  %.781.us.i.i = load i64, ptr %.780.us.i.i, align 8
  %.782.us.i.i = icmp eq i64 %.781.us.i.i, 1
  br i1 %.782.us.i.i, label %B336.us.i.i, label %B406.endif.us.i.i

B406.endif.us.i.i:                                ; preds = %B226.us.i.i
  %.923.us.i.i = load double, ptr %sunkaddr275.i, align 8
  %.46.i.i.i = select i1 %.765.us.i.i, i64 %w1, i64 0
  %.47.i.i.i = add i64 %.46.i.i.i, %.559.us.i.i
  %.67.i.i.i = mul i64 %.47.i.i.i, %w2
  %24 = getelementptr double, ptr %w0, i64 %.67.i.i.i
  %.71.i.i.i = getelementptr i8, ptr %24, i64 16
  %.72.i.i.i = load double, ptr %.71.i.i.i, align 8
  %.125.i.i.i = load double, ptr %sunkaddr277.i, align 8
  %.126.i.i.i = fsub double %.72.i.i.i, %.125.i.i.i
  %.234.i.i.i = fmul double %.126.i.i.i, %.126.i.i.i
  %.287.i.i.i = load double, ptr %24, align 8
  %.340.i.i.i = load double, ptr %sunkaddr276.i, align 8
  %.341.i.i.i = fsub double %.287.i.i.i, %.340.i.i.i
  %.449.i.i.i = fmul double %.341.i.i.i, %.341.i.i.i
  %.501.i.i.i = getelementptr i8, ptr %24, i64 8
  %.502.i.i.i = load double, ptr %.501.i.i.i, align 8
  %.555.i.i.i = load double, ptr %sunkaddr280.i, align 8
  %.556.i.i.i = fsub double %.502.i.i.i, %.555.i.i.i
  %.664.i.i.i = fmul double %.556.i.i.i, %.556.i.i.i
  %.665.i.i.i = fadd double %.449.i.i.i, %.664.i.i.i
  %.666.i.i.i = fadd double %.234.i.i.i, %.665.i.i.i
  %sqrt.i.i = tail call double @llvm.sqrt.f64(double %.666.i.i.i)
  %.958.us.i.i = fadd double %.923.us.i.i, %sqrt.i.i
  br label %B490.us.i.i

B336.us.i.i:                                      ; preds = %B226.us.i.i
  %.630.us.i.i = load i64, ptr %21, align 8
  %.685.us.i.i = load i64, ptr %sunkaddr281.i, align 8
  %.741.us.i.i = load i64, ptr %sunkaddr282.i, align 8
  %25 = add i64 %.559.us.i.i, %.us-phi3609.i
  %.686.us.i.i = sub i64 %.630.us.i.i, %25
  %.742.us.i.i = add i64 %.686.us.i.i, %.685.us.i.i
  %.746.us.i.i = add i64 %.742.us.i.i, %.741.us.i.i
  %.72.i.i5.i = load double, ptr %.71.i.i4.i, align 8
  %.99.i.i6.i = select i1 %.765.us.i.i, i64 %w1, i64 0
  %.100.i.i7.i = add i64 %.99.i.i6.i, %.559.us.i.i
  %.120.i.i.i = mul i64 %.100.i.i7.i, %w2
  %26 = getelementptr double, ptr %w0, i64 %.120.i.i.i
  %.124.i.i.i = getelementptr i8, ptr %26, i64 16
  %.125.i.i8.i = load double, ptr %.124.i.i.i, align 8
  %.126.i.i9.i = fsub double %.72.i.i5.i, %.125.i.i8.i
  %.234.i.i10.i = fmul double %.126.i.i9.i, %.126.i.i9.i
  %.287.i.i11.i = load double, ptr %19, align 8
  %.340.i.i12.i = load double, ptr %26, align 8
  %.341.i.i13.i = fsub double %.287.i.i11.i, %.340.i.i12.i
  %.449.i.i14.i = fmul double %.341.i.i13.i, %.341.i.i13.i
  %.502.i.i16.i = load double, ptr %.501.i.i15.i, align 8
  %.554.i.i.i = getelementptr i8, ptr %26, i64 8
  %.555.i.i17.i = load double, ptr %.554.i.i.i, align 8
  %.556.i.i18.i = fsub double %.502.i.i16.i, %.555.i.i17.i
  %.664.i.i19.i = fmul double %.556.i.i18.i, %.556.i.i18.i
  %.665.i.i20.i = fadd double %.449.i.i14.i, %.664.i.i19.i
  %.666.i.i21.i = fadd double %.234.i.i10.i, %.665.i.i20.i
  %sqrt77.i.i = tail call double @llvm.sqrt.f64(double %.666.i.i21.i)
  %.79.i22.i = fcmp une double %.666.i.i21.i, 0.000000e+00
  br i1 %.79.i22.i, label %B96.endif.endif.endif.endif.i.i, label %B490.us.i.i

B328.i.i:                                         ; preds = %B96.endif.endif.endif.endif.i.i
  %.234.i59.i.i = fmul double %.233.i20.i.i, %.233.i20.i.i
  %.449.i65.i.i = fmul double %.448.i26.i.i, %.448.i26.i.i
  %.664.i74.i.i = fmul double %.663.i35.i.i, %.663.i35.i.i
  %.665.i75.i.i = fadd double %.449.i65.i.i, %.664.i74.i.i
  %.666.i76.i.i = fadd double %.234.i59.i.i, %.665.i75.i.i
  %.183.i.i = fmul double %.138.i.i, %.138.i.i
  %.184.i26.i = fsub double %.666.i76.i.i, %.183.i.i
  %.10.i.i.i = fcmp olt double %.184.i26.i, 0.000000e+00
  %.11.i.i.i = select i1 %.10.i.i.i, double 0.000000e+00, double %.184.i26.i
  %sqrt78.i.i = tail call double @llvm.sqrt.f64(double %.11.i.i.i)
  %.269.i27.i = tail call double @sqrt(double %.248.i.i)
  %.277.i.i = fadd double %sqrt78.i.i, %.269.i27.i
  %.279.i28.i = fcmp ogt double %.277.i.i, 0.000000e+00
  br i1 %.279.i28.i, label %B412.i.i, label %B490.us.i.i

B412.i.i:                                         ; preds = %B328.i.i
  %.283.i.i = fsub double %.138.i.i, %.236.i25.i
  %.285.i.i = fmul double %.283.i.i, %.269.i27.i
  %.292.i.i = fdiv double %.285.i.i, %.277.i.i
  %.294.i29.i = fadd double %.236.i25.i, %.292.i.i
  %.306.i30.i = fcmp oge double %.294.i29.i, 0.000000e+00
  %.313.i.i = fcmp ole double %.294.i29.i, %sqrt77.i.i
  %or.cond.i.i = and i1 %.306.i30.i, %.313.i.i
  br i1 %or.cond.i.i, label %B446.i.i, label %B490.us.i.i

B446.i.i:                                         ; preds = %B412.i.i
  %.343.i.i = fmul double %.283.i.i, %.283.i.i
  %.354.i31.i = fmul double %.277.i.i, %.277.i.i
  %.355.i.i = fadd double %.343.i.i, %.354.i31.i
  %sqrt.i32.i = tail call double @llvm.sqrt.f64(double %.355.i.i)
  br label %B490.us.i.i

B96.endif.endif.endif.endif.i.i:                  ; preds = %B336.us.i.i
  %.846.us.i.i = load double, ptr %sunkaddr275.i, align 8
  %27 = getelementptr double, ptr %w15, i64 %.559.us.i.i
  %.800.us.i.i = select i1 %.765.us.i.i, i64 %w16, i64 0
  %.814.us.i.i = getelementptr double, ptr %27, i64 %.800.us.i.i
  %.815.us.i.i = load double, ptr %.814.us.i.i, align 8
  %.152.i14.i.i = icmp slt i64 %.746.us.i.i, 0
  %.153.i15.i.i = select i1 %.152.i14.i.i, i64 %w1, i64 0
  %.154.i16.i.i = add i64 %.153.i15.i.i, %.746.us.i.i
  %.174.i17.i.i = mul i64 %.154.i16.i.i, %w2
  %28 = getelementptr double, ptr %w0, i64 %.174.i17.i.i
  %.178.i18.i.i = getelementptr i8, ptr %28, i64 16
  %.179.i19.i.i = load double, ptr %.178.i18.i.i, align 8
  %.233.i20.i.i = fsub double %.179.i19.i.i, %.125.i.i8.i
  %.234.i21.i.i = fmul double %.126.i.i9.i, %.233.i20.i.i
  %.394.i25.i.i = load double, ptr %28, align 8
  %.448.i26.i.i = fsub double %.394.i25.i.i, %.340.i.i12.i
  %.449.i27.i.i = fmul double %.341.i.i13.i, %.448.i26.i.i
  %.608.i33.i.i = getelementptr i8, ptr %28, i64 8
  %.609.i34.i.i = load double, ptr %.608.i33.i.i, align 8
  %.663.i35.i.i = fsub double %.609.i34.i.i, %.555.i.i17.i
  %.664.i36.i.i = fmul double %.556.i.i18.i, %.663.i35.i.i
  %.665.i37.i.i = fadd double %.449.i27.i.i, %.664.i36.i.i
  %.666.i38.i.i = fadd double %.234.i21.i.i, %.665.i37.i.i
  %.138.i.i = fdiv double %.666.i38.i.i, %sqrt77.i.i
  %.219.i23.i = fmul double %.815.us.i.i, %.815.us.i.i
  %.222.i.i = fmul double %.846.us.i.i, %.846.us.i.i
  %.225.i.i = fsub double %.219.i23.i, %.222.i.i
  %.227.i.i = fadd double %.666.i.i21.i, %.225.i.i
  %.232.i24.i = fmul double %sqrt77.i.i, 2.000000e+00
  %.236.i25.i = fdiv double %.227.i.i, %.232.i24.i
  %.247.i.i = fmul double %.236.i25.i, %.236.i25.i
  %.248.i.i = fsub double %.219.i23.i, %.247.i.i
  %.254.i.i = fcmp olt double %.248.i.i, 0.000000e+00
  br i1 %.254.i.i, label %B490.us.i.i, label %B328.i.i

B490.us.i.i:                                      ; preds = %B96.endif.endif.endif.endif.i.i, %B446.i.i, %B412.i.i, %B328.i.i, %B336.us.i.i, %B406.endif.us.i.i
  %away.2.3.us.i.i = phi double [ %.958.us.i.i, %B406.endif.us.i.i ], [ 0x7FF0000000000000, %B96.endif.endif.endif.endif.i.i ], [ 0x7FF0000000000000, %B336.us.i.i ], [ %sqrt.i32.i, %B446.i.i ], [ 0x7FF0000000000000, %B412.i.i ], [ 0x7FF0000000000000, %B328.i.i ]
  %target.2.3.us.i.i = phi i64 [ %.559.us.i.i, %B406.endif.us.i.i ], [ %.746.us.i.i, %B96.endif.endif.endif.endif.i.i ], [ %.746.us.i.i, %B336.us.i.i ], [ %.746.us.i.i, %B446.i.i ], [ %.746.us.i.i, %B412.i.i ], [ %.746.us.i.i, %B328.i.i ]
  %.986.us.i.i = icmp slt i64 %target.2.3.us.i.i, 0
  %.987.us.i.i = select i1 %.986.us.i.i, i64 %w18, i64 0
  %29 = getelementptr i64, ptr %w17, i64 %target.2.3.us.i.i
  %.1001.us.i.i = getelementptr i64, ptr %29, i64 %.987.us.i.i
  %.1002.us.i.i = load i64, ptr %.1001.us.i.i, align 8
  %.1003.not.us.i.i = icmp eq i64 %.1002.us.i.i, 1
  br i1 %.1003.not.us.i.i, label %B599.us.i.i, label %B524.us.i.i

B524.us.i.i:                                      ; preds = %B490.us.i.i
  %.1023.us.i.i = select i1 %.986.us.i.i, i64 %w16, i64 0
  %30 = getelementptr double, ptr %w15, i64 %target.2.3.us.i.i
  %.1037.us.i.i = getelementptr double, ptr %30, i64 %.1023.us.i.i
  %.1038.us.i.i = load double, ptr %.1037.us.i.i, align 8
  %.1040.us.i.i = fcmp olt double %away.2.3.us.i.i, %.1038.us.i.i
  br i1 %.1040.us.i.i, label %B548.us.i.i, label %B599.us.i.i

B548.us.i.i:                                      ; preds = %B524.us.i.i
  %sunkaddr17.i.i = shl i64 %.1023.us.i.i, 3
  %sunkaddr18.i.i = getelementptr inbounds i8, ptr %30, i64 %sunkaddr17.i.i
  store double %away.2.3.us.i.i, ptr %sunkaddr18.i.i, align 8
  %.96.i.i.i = icmp sgt i64 %size.2.1772.us.i.i, 0
  br i1 %.96.i.i.i, label %B20.else.if.i.i.i, label %_ZN7msf_jax4host4thin6fronts4pushB3v39B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx.exit.i.i

B20.else.if.i.i.i:                                ; preds = %B548.us.i.i
  %.108.i.i.i = add nsw i64 %size.2.1772.us.i.i, -1
  %.129416426.i.i.i = lshr i64 %.108.i.i.i, 1
  %.178.i1.i.i = getelementptr double, ptr %w25, i64 %.129416426.i.i.i
  %.179.i2.i.i = load double, ptr %.178.i1.i.i, align 8
  %.181.i.i.i = fcmp ogt double %.179.i2.i.i, %away.2.3.us.i.i
  br i1 %.181.i.i.i, label %B66.else.if.i.i.i, label %_ZN7msf_jax4host4thin6fronts4pushB3v39B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx.exit.i.i

B66.else.if.i.i.i:                                ; preds = %B20.else.if.i.i.i, %B204.else.if.i.i.i
  %at.2.1.i.i.i = phi i64 [ %.208418427.i.i.i, %B204.else.if.i.i.i ], [ %size.2.1772.us.i.i, %B20.else.if.i.i.i ]
  %.189.i.i.i = add nsw i64 %at.2.1.i.i.i, -1
  %.208418427.i.i.i = lshr i64 %.189.i.i.i, 1
  %.257.i.i.i = getelementptr double, ptr %w25, i64 %.208418427.i.i.i
  %.258.i.i.i = load double, ptr %.257.i.i.i, align 8
  %.330.i.i.i = getelementptr i64, ptr %w27, i64 %.208418427.i.i.i
  %.331.i.i.i = load i64, ptr %.330.i.i.i, align 8
  %.362.i.i.i = getelementptr double, ptr %w25, i64 %at.2.1.i.i.i
  store double %.258.i.i.i, ptr %.362.i.i.i, align 8
  %.394.i3.i.i = getelementptr i64, ptr %w27, i64 %at.2.1.i.i.i
  store i64 %.331.i.i.i, ptr %.394.i3.i.i, align 8
  %.447.not.i.i.i = icmp eq i64 %.208418427.i.i.i, 0
  br i1 %.447.not.i.i.i, label %_ZN7msf_jax4host4thin6fronts4pushB3v39B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx.exit.i.i, label %B204.else.if.i.i.i

B204.else.if.i.i.i:                               ; preds = %B66.else.if.i.i.i
  %.458.i.i.i = add nsw i64 %.208418427.i.i.i, -1
  %.479424430.i.i.i = lshr i64 %.458.i.i.i, 1
  %.528.i.i.i = getelementptr double, ptr %w25, i64 %.479424430.i.i.i
  %.529.i.i.i = load double, ptr %.528.i.i.i, align 8
  %.531.i.i.i = fcmp ogt double %.529.i.i.i, %away.2.3.us.i.i
  br i1 %.531.i.i.i, label %B66.else.if.i.i.i, label %_ZN7msf_jax4host4thin6fronts4pushB3v39B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx.exit.i.i

_ZN7msf_jax4host4thin6fronts4pushB3v39B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx.exit.i.i: ; preds = %B204.else.if.i.i.i, %B66.else.if.i.i.i, %B20.else.if.i.i.i, %B548.us.i.i
  %at.3.0.i.i.i = phi i64 [ %size.2.1772.us.i.i, %B20.else.if.i.i.i ], [ %size.2.1772.us.i.i, %B548.us.i.i ], [ 0, %B66.else.if.i.i.i ], [ %.208418427.i.i.i, %B204.else.if.i.i.i ]
  %.560.i.i.i = icmp slt i64 %at.3.0.i.i.i, 0
  %.561.i.i.i = select i1 %.560.i.i.i, i64 %w26, i64 0
  %31 = getelementptr double, ptr %w25, i64 %at.3.0.i.i.i
  %.575.i.i.i = getelementptr double, ptr %31, i64 %.561.i.i.i
  store double %away.2.3.us.i.i, ptr %.575.i.i.i, align 8
  %.598.i.i.i = select i1 %.560.i.i.i, i64 %w28, i64 0
  %32 = getelementptr i64, ptr %w27, i64 %at.3.0.i.i.i
  %.612.i.i.i = getelementptr i64, ptr %32, i64 %.598.i.i.i
  store i64 %target.2.3.us.i.i, ptr %.612.i.i.i, align 8
  %.619.i.i.i = add nsw i64 %size.2.1772.us.i.i, 1
  br label %B599.us.i.i

B599.us.i.i:                                      ; preds = %_ZN7msf_jax4host4thin6fronts4pushB3v39B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx.exit.i.i, %B524.us.i.i, %B490.us.i.i, %B190.us.i.i
  %size.4.2.us.i.i = phi i64 [ %size.2.1772.us.i.i, %B190.us.i.i ], [ %size.2.1772.us.i.i, %B490.us.i.i ], [ %size.2.1772.us.i.i, %B524.us.i.i ], [ %.619.i.i.i, %_ZN7msf_jax4host4thin6fronts4pushB3v39B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx.exit.i.i ]
  %exitcond.not.i.i = icmp eq i64 %.484.us.i.i, 3
  br i1 %exitcond.not.i.i, label %B188.B128.loopexit_crit_edge.us.i.i, label %B190.us.i.i

B188.B128.loopexit_crit_edge.us.i.i:              ; preds = %B599.us.i.i
  %.323.us.i.i = add nsw i64 %.313775787.us.i.i, -1
  %.327.us.i.i = add i64 %.320778786.us.i.i, 1
  %.314.us.i.i = icmp sgt i64 %.313775787.us.i.i, 1
  br i1 %.314.us.i.i, label %B130.endif.endif.us.i.i, label %B568.i

B568.i:                                           ; preds = %B188.B128.loopexit_crit_edge.us.i.i, %B380.endif.i, %B530.i
  %count.3.1.i = phi i64 [ %count.2.03906.i, %B380.endif.i ], [ %.950.i, %B530.i ], [ %.950.i, %B188.B128.loopexit_crit_edge.us.i.i ]
  %goes_on.6.1.i = phi i1 [ true, %B380.endif.i ], [ %"$phi530.0.2.1.i", %B530.i ], [ %"$phi530.0.2.1.i", %B188.B128.loopexit_crit_edge.us.i.i ]
  %size.4.1.i = phi i64 [ %.79.i.i, %B380.endif.i ], [ %.79.i.i, %B530.i ], [ %size.4.2.us.i.i, %B188.B128.loopexit_crit_edge.us.i.i ]
  %.661.not3157.i = icmp ne i64 %size.4.1.i, 0
  %brmerge.not.i = select i1 %.661.not3157.i, i1 %goes_on.6.1.i, i1 false
  br i1 %brmerge.not.i, label %B316.preheader.i, label %B2590.i

B570.i:                                           ; preds = %B316.i
  %.1178.i = icmp slt i64 %rows.2.2.i, %.493.i
  br i1 %.1178.i, label %B740.endif.preheader.i, label %B2584.i

B738.loopexit.i:                                  ; preds = %B2763.i, %B740.endif.i
  %rings.2.4.lcssa.i = phi i64 [ %rings.5.33332.i, %B740.endif.i ], [ %rings.3.5.i, %B2763.i ]
  %longest.3.4.lcssa.i = phi i64 [ %longest.2.33333.i, %B740.endif.i ], [ %longest.4.5.i, %B2763.i ]
  %exitcond.not.i = icmp eq i64 %.1488.i, %count.2.03906.i
  br i1 %exitcond.not.i, label %B1304.i, label %B740.endif.i

B870.i:                                           ; preds = %B870.preheader.i, %B2763.i
  %lsr.iv.i = phi i64 [ %162, %B870.preheader.i ], [ %lsr.iv.next.i, %B2763.i ]
  %longest.3.43284.i = phi i64 [ %longest.2.33333.i, %B870.preheader.i ], [ %longest.4.5.i, %B2763.i ]
  %rings.2.43283.i = phi i64 [ %rings.5.33332.i, %B870.preheader.i ], [ %rings.3.5.i, %B2763.i ]
  %.173532403281.i = phi i64 [ %.1586.i, %B870.preheader.i ], [ %.1742.i, %B2763.i ]
  %.1781.i = icmp slt i64 %.173532403281.i, 0
  %33 = select i1 %.1781.i, i64 %3, i64 0
  %scevgep205.i = getelementptr i8, ptr %w10, i64 %33
  %34 = shl i64 %.173532403281.i, 3
  %scevgep206.i = getelementptr i8, ptr %scevgep205.i, i64 %34
  %.1797.i = load i64, ptr %scevgep206.i, align 8
  %.304.i.i = icmp slt i64 %.1797.i, 0
  %.305.i.i = select i1 %.304.i.i, i64 %w4, i64 0
  %.306.i.i = add i64 %.305.i.i, %.1797.i
  %.326.i.i = mul i64 %.306.i.i, %w5
  %35 = getelementptr i64, ptr %w3, i64 %.326.i.i
  %.331.i.i = load i64, ptr %35, align 8
  %.344.i.i = icmp slt i64 %.331.i.i, 0
  %.345.i.i = select i1 %.344.i.i, i64 %w18, i64 0
  %36 = getelementptr i64, ptr %w17, i64 %.331.i.i
  %.359.i.i = getelementptr i64, ptr %36, i64 %.345.i.i
  %.360.i.i = load i64, ptr %.359.i.i, align 8
  %.361.i.i = icmp eq i64 %.360.i.i, 1
  %.364.i.i = zext i1 %.361.i.i to i64
  %37 = getelementptr i8, ptr %35, i64 8
  %.331.1.i.i = load i64, ptr %37, align 8
  %.344.1.i.i = icmp slt i64 %.331.1.i.i, 0
  %.345.1.i.i = select i1 %.344.1.i.i, i64 %w18, i64 0
  %38 = getelementptr i64, ptr %w17, i64 %.331.1.i.i
  %.359.1.i.i = getelementptr i64, ptr %38, i64 %.345.1.i.i
  %.360.1.i.i = load i64, ptr %.359.1.i.i, align 8
  %.361.1.i.i = icmp eq i64 %.360.1.i.i, 1
  %.364.1.i.i = zext i1 %.361.1.i.i to i64
  %.365.1.i.i = add nuw nsw i64 %.364.1.i.i, %.364.i.i
  %39 = getelementptr i8, ptr %35, i64 16
  %.331.2.i.i = load i64, ptr %39, align 8
  %.344.2.i.i = icmp slt i64 %.331.2.i.i, 0
  %.345.2.i.i = select i1 %.344.2.i.i, i64 %w18, i64 0
  %40 = getelementptr i64, ptr %w17, i64 %.331.2.i.i
  %.359.2.i.i = getelementptr i64, ptr %40, i64 %.345.2.i.i
  %.360.2.i.i = load i64, ptr %.359.2.i.i, align 8
  %.361.2.i.i = icmp eq i64 %.360.2.i.i, 1
  %.364.2.i.i = zext i1 %.361.2.i.i to i64
  %.365.2.i.i = add nuw nsw i64 %.365.1.i.i, %.364.2.i.i
  switch i64 %.365.2.i.i, label %B1046.i [
    i64 0, label %B140.endif.i.i
    i64 3, label %B140.endif.i.i
  ]

B140.endif.i.i:                                   ; preds = %B870.i, %B870.i
  %.406546.cmp.i.i = icmp samesign ugt i64 %.365.2.i.i, 2
  br i1 %.406546.cmp.i.i, label %B976.endif.lr.ph.i, label %B1046.i

B1046.i:                                          ; preds = %B140.endif.i.i, %B870.i
  %.2144.i = select i1 %.304.i.i, i64 %w30, i64 0
  %41 = getelementptr i64, ptr %w29, i64 %.1797.i
  %.2158.i = getelementptr i64, ptr %41, i64 %.2144.i
  %.2159.i = load i64, ptr %.2158.i, align 8
  %.2160.i = icmp slt i64 %.2159.i, 0
  br i1 %.2160.i, label %B1080.i, label %B2763.i

B1080.i:                                          ; preds = %B1046.i
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %.281.i, i8 0, i64 72, i1 false)
  %.361.i35.i = load i64, ptr %.2158.i, align 8
  %.362.i.i = icmp slt i64 %.361.i35.i, 0
  br i1 %.362.i.i, label %B104.i.i, label %_ZN7msf_jax4host4thin6fronts12ring_throughB3v45B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx5ArrayIdLi1E1C7mutable7alignedE.exit.i

B104.i.i:                                         ; preds = %B1080.i, %B1016.i.i
  %face.2.0.i.i = phi i64 [ %.2246.1.i.i, %B1016.i.i ], [ %.1797.i, %B1080.i ]
  %.383.i.i = icmp slt i64 %face.2.0.i.i, 0
  %.384.i.i = select i1 %.383.i.i, i64 %w30, i64 0
  %42 = getelementptr i64, ptr %w29, i64 %face.2.0.i.i
  %.398.i.i = getelementptr i64, ptr %42, i64 %.384.i.i
  store i64 %rings.2.43283.i, ptr %.398.i.i, align 8
  %.305.i.i.i = select i1 %.383.i.i, i64 %w4, i64 0
  %.306.i.i.i = add i64 %.305.i.i.i, %face.2.0.i.i
  %.326.i.i.i = mul i64 %.306.i.i.i, %w5
  %43 = getelementptr i64, ptr %w3, i64 %.326.i.i.i
  %.331.i.i37.i = load i64, ptr %43, align 8
  %.344.i.i.i = icmp slt i64 %.331.i.i37.i, 0
  %.345.i.i.i = select i1 %.344.i.i.i, i64 %w18, i64 0
  %44 = getelementptr i64, ptr %w17, i64 %.331.i.i37.i
  %.359.i.i.i = getelementptr i64, ptr %44, i64 %.345.i.i.i
  %.360.i.i.i = load i64, ptr %.359.i.i.i, align 8
  %.361.i.i.i = icmp eq i64 %.360.i.i.i, 1
  %.364.i.i.i = zext i1 %.361.i.i.i to i64
  %45 = getelementptr i8, ptr %43, i64 8
  %.331.1.i.i.i = load i64, ptr %45, align 8
  %.344.1.i.i.i = icmp slt i64 %.331.1.i.i.i, 0
  %.345.1.i.i.i = select i1 %.344.1.i.i.i, i64 %w18, i64 0
  %46 = getelementptr i64, ptr %w17, i64 %.331.1.i.i.i
  %.359.1.i.i.i = getelementptr i64, ptr %46, i64 %.345.1.i.i.i
  %.360.1.i.i.i = load i64, ptr %.359.1.i.i.i, align 8
  %.361.1.i.i.i = icmp eq i64 %.360.1.i.i.i, 1
  %.364.1.i.i.i = zext i1 %.361.1.i.i.i to i64
  %.365.1.i.i.i = add nuw nsw i64 %.364.1.i.i.i, %.364.i.i.i
  %47 = getelementptr i8, ptr %43, i64 16
  %.331.2.i.i.i = load i64, ptr %47, align 8
  %.344.2.i.i.i = icmp slt i64 %.331.2.i.i.i, 0
  %.345.2.i.i.i = select i1 %.344.2.i.i.i, i64 %w18, i64 0
  %48 = getelementptr i64, ptr %w17, i64 %.331.2.i.i.i
  %.359.2.i.i.i = getelementptr i64, ptr %48, i64 %.345.2.i.i.i
  %.360.2.i.i.i = load i64, ptr %.359.2.i.i.i, align 8
  %.361.2.i.i.i = icmp eq i64 %.360.2.i.i.i, 1
  %.364.2.i.i.i = zext i1 %.361.2.i.i.i to i64
  %.365.2.i.i.i = add nuw nsw i64 %.365.1.i.i.i, %.364.2.i.i.i
  switch i64 %.365.2.i.i.i, label %B156.endif.endif.i.i.i [
    i64 0, label %B140.endif.i.i.i
    i64 3, label %B140.endif.i.i.i
  ]

B140.endif.i.i.i:                                 ; preds = %B104.i.i, %B104.i.i
  %.406546.cmp.i.i.i = icmp samesign ugt i64 %.365.2.i.i.i, 2
  %.430.i.i.i = select i1 %.406546.cmp.i.i.i, i64 7, i64 6
  br label %B1016.i.i

B156.endif.endif.i.i.i:                           ; preds = %B104.i.i
  %49 = icmp ne i64 %.365.2.i.i.i, 1
  %.652.1.i.i.i = xor i1 %.361.1.i.i.i, %49
  %spec.select.1.i.i.i = zext i1 %.652.1.i.i.i to i64
  %.652.2.i.i.i = xor i1 %.361.2.i.i.i, %49
  %spec.select.2.i.i.i = select i1 %.652.2.i.i.i, i64 2, i64 %spec.select.1.i.i.i
  %.679.i.i.i = icmp eq i64 %.365.2.i.i.i, 1
  %.691.i.i.i = add nuw nsw i64 %spec.select.2.i.i.i, 3
  %spec.select548.i.i.i = select i1 %.679.i.i.i, i64 %spec.select.2.i.i.i, i64 %.691.i.i.i
  br label %B1016.i.i

B1016.i.i:                                        ; preds = %B156.endif.endif.i.i.i, %B140.endif.i.i.i
  %storemerge.i.i.i = phi i64 [ %.430.i.i.i, %B140.endif.i.i.i ], [ %spec.select548.i.i.i, %B156.endif.endif.i.i.i ]
  %storemerge.i.fr.i.i = freeze i64 %storemerge.i.i.i
  %.4852.lhs.trunc.i.i = trunc i64 %storemerge.i.fr.i.i to i8
  %.48523.i.i = urem i8 %.4852.lhs.trunc.i.i, 3
  %.4852.zext.i.i = zext nneg i8 %.48523.i.i to i64
  %50 = getelementptr i64, ptr %43, i64 %.4852.zext.i.i
  %.561.i.i = load i64, ptr %50, align 8
  %.585.lhs.trunc.i.i = add nuw nsw i8 %.48523.i.i, 1
  %51 = icmp eq i8 %.585.lhs.trunc.i.i, 3
  %.58513054.i.i = select i1 %51, i8 0, i8 %.585.lhs.trunc.i.i
  %.585.sext.i.i = zext nneg i8 %.58513054.i.i to i64
  %52 = getelementptr i64, ptr %43, i64 %.585.sext.i.i
  %.655.i.i = load i64, ptr %52, align 8
  %53 = tail call { i8, i1 } @llvm.usub.with.overflow.i8(i8 %.48523.i.i, i8 1)
  %math.i.i = extractvalue { i8, i1 } %53, 0
  %ov.i.i = extractvalue { i8, i1 } %53, 1
  %54 = zext nneg i8 %math.i.i to i64
  %.6791308.zext.i.i = select i1 %ov.i.i, i64 2, i64 %54
  %.748.i.i = getelementptr i64, ptr %43, i64 %.6791308.zext.i.i
  %.749.i.i = load i64, ptr %.748.i.i, align 8
  %.774.i.i = icmp slt i64 %.561.i.i, 0
  %.775.i.i = select i1 %.774.i.i, i64 %w16, i64 0
  %55 = getelementptr double, ptr %w15, i64 %.561.i.i
  %.789.i.i = getelementptr double, ptr %55, i64 %.775.i.i
  %.790.i.i = load double, ptr %.789.i.i, align 8
  %.792.i.i = fsub double %level.2.2.i, %.790.i.i
  %.808.i.i = icmp slt i64 %.655.i.i, 0
  %.809.i.i = select i1 %.808.i.i, i64 %w16, i64 0
  %56 = getelementptr double, ptr %w15, i64 %.655.i.i
  %.823.i.i = getelementptr double, ptr %56, i64 %.809.i.i
  %.824.i.i = load double, ptr %.823.i.i, align 8
  %.857.i.i = fsub double %.824.i.i, %.790.i.i
  %.861.i.i = fdiv double %.792.i.i, %.857.i.i
  %.914.i.i = icmp slt i64 %.749.i.i, 0
  %.915.i.i = select i1 %.914.i.i, i64 %w16, i64 0
  %57 = getelementptr double, ptr %w15, i64 %.749.i.i
  %.929.i.i = getelementptr double, ptr %57, i64 %.915.i.i
  %.930.i.i = load double, ptr %.929.i.i, align 8
  %.963.i.i = fsub double %.930.i.i, %.790.i.i
  %.967.i.i = fdiv double %.792.i.i, %.963.i.i
  %.1115.i.i = select i1 %.808.i.i, i64 %w1, i64 0
  %.1116.i.i = add i64 %.1115.i.i, %.655.i.i
  %.1136.i.i = mul i64 %.1116.i.i, %w2
  %58 = getelementptr double, ptr %w0, i64 %.1136.i.i
  %.1166.i.i = select i1 %.774.i.i, i64 %w1, i64 0
  %.1167.i.i = add i64 %.1166.i.i, %.561.i.i
  %.1187.i.i = mul i64 %.1167.i.i, %w2
  %59 = getelementptr double, ptr %w0, i64 %.1187.i.i
  %.1220.i.i = select i1 %.914.i.i, i64 %w1, i64 0
  %.1221.i.i = add i64 %.1220.i.i, %.749.i.i
  %.1241.i.i = mul i64 %.1221.i.i, %w2
  %60 = getelementptr double, ptr %w0, i64 %.1241.i.i
  %.1141.i.i = load double, ptr %58, align 8
  %.1192.i.i = load double, ptr %59, align 8
  %.1193.i.i = fsub double %.1141.i.i, %.1192.i.i
  %.1195.i.i = fmul double %.861.i.i, %.1193.i.i
  %.1246.i.i = load double, ptr %60, align 8
  %.1298.i.i = fsub double %.1246.i.i, %.1192.i.i
  %.1300.i.i = fmul double %.967.i.i, %.1298.i.i
  %.1301.i.i = fsub double %.1195.i.i, %.1300.i.i
  %.1302.i.i = fmul double %.1301.i.i, %.1301.i.i
  %.1140.1.i.i = getelementptr i8, ptr %58, i64 8
  %.1141.1.i.i = load double, ptr %.1140.1.i.i, align 8
  %.1191.1.i.i = getelementptr i8, ptr %59, i64 8
  %.1192.1.i.i = load double, ptr %.1191.1.i.i, align 8
  %.1193.1.i.i = fsub double %.1141.1.i.i, %.1192.1.i.i
  %.1195.1.i.i = fmul double %.861.i.i, %.1193.1.i.i
  %.1245.1.i.i = getelementptr i8, ptr %60, i64 8
  %.1246.1.i.i = load double, ptr %.1245.1.i.i, align 8
  %.1298.1.i.i = fsub double %.1246.1.i.i, %.1192.1.i.i
  %.1300.1.i.i = fmul double %.967.i.i, %.1298.1.i.i
  %.1301.1.i.i = fsub double %.1195.1.i.i, %.1300.1.i.i
  %.1302.1.i.i = fmul double %.1301.1.i.i, %.1301.1.i.i
  %.1304.1.i.i = fadd double %.1302.i.i, %.1302.1.i.i
  %.1140.2.i.i = getelementptr i8, ptr %58, i64 16
  %.1141.2.i.i = load double, ptr %.1140.2.i.i, align 8
  %.1191.2.i.i = getelementptr i8, ptr %59, i64 16
  %.1192.2.i.i = load double, ptr %.1191.2.i.i, align 8
  %.1193.2.i.i = fsub double %.1141.2.i.i, %.1192.2.i.i
  %.1195.2.i.i = fmul double %.861.i.i, %.1193.2.i.i
  %.1245.2.i.i = getelementptr i8, ptr %60, i64 16
  %.1246.2.i.i = load double, ptr %.1245.2.i.i, align 8
  %.1298.2.i.i = fsub double %.1246.2.i.i, %.1192.2.i.i
  %.1300.2.i.i = fmul double %.967.i.i, %.1298.2.i.i
  %.1301.2.i.i = fsub double %.1195.2.i.i, %.1300.2.i.i
  %.1302.2.i.i = fmul double %.1301.2.i.i, %.1301.2.i.i
  %.1304.2.i.i = fadd double %.1304.1.i.i, %.1302.2.i.i
  %sqrt.i38.i = tail call double @llvm.sqrt.f64(double %.1304.2.i.i)
  %.1348.i.i = load double, ptr %.281.i, align 8
  %.1350.i.i = fadd double %.1348.i.i, %sqrt.i38.i
  store double %.1350.i.i, ptr %.281.i, align 8
  %.1528.i.i = load double, ptr %sunkaddr1.i.i, align 8
  %.1579.i.i = load double, ptr %59, align 8
  %.1630.i.i = load double, ptr %58, align 8
  %.1682.i.i = fsub double %.1630.i.i, %.1579.i.i
  %.1684.i.i = fmul double %.861.i.i, %.1682.i.i
  %.1735.i.i = load double, ptr %60, align 8
  %.1787.i.i = fsub double %.1735.i.i, %.1579.i.i
  %.1789.i.i = fmul double %.967.i.i, %.1787.i.i
  %.1790.i.i = fadd double %.1684.i.i, %.1789.i.i
  %.1795.i.i = fmul double %.1790.i.i, 5.000000e-01
  %.1796.i.i = fadd double %.1579.i.i, %.1795.i.i
  %.1798.i.i = fmul double %sqrt.i38.i, %.1796.i.i
  %.1799.i.i = fadd double %.1528.i.i, %.1798.i.i
  store double %.1799.i.i, ptr %sunkaddr1.i.i, align 8
  %.1528.1.i.i = load double, ptr %sunkaddr.i36.i, align 8
  %.1579.1.i.i = load double, ptr %.1191.1.i.i, align 8
  %.1630.1.i.i = load double, ptr %.1140.1.i.i, align 8
  %.1682.1.i.i = fsub double %.1630.1.i.i, %.1579.1.i.i
  %.1684.1.i.i = fmul double %.861.i.i, %.1682.1.i.i
  %.1735.1.i.i = load double, ptr %.1245.1.i.i, align 8
  %.1787.1.i.i = fsub double %.1735.1.i.i, %.1579.1.i.i
  %.1789.1.i.i = fmul double %.967.i.i, %.1787.1.i.i
  %.1790.1.i.i = fadd double %.1684.1.i.i, %.1789.1.i.i
  %.1795.1.i.i = fmul double %.1790.1.i.i, 5.000000e-01
  %.1796.1.i.i = fadd double %.1579.1.i.i, %.1795.1.i.i
  %.1798.1.i.i = fmul double %sqrt.i38.i, %.1796.1.i.i
  %.1799.1.i.i = fadd double %.1528.1.i.i, %.1798.1.i.i
  store double %.1799.1.i.i, ptr %sunkaddr.i36.i, align 8
  %.1528.2.i.i = load double, ptr %sunkaddr2.i.i, align 8
  %.1579.2.i.i = load double, ptr %.1191.2.i.i, align 8
  %.1630.2.i.i = load double, ptr %.1140.2.i.i, align 8
  %.1682.2.i.i = fsub double %.1630.2.i.i, %.1579.2.i.i
  %.1684.2.i.i = fmul double %.861.i.i, %.1682.2.i.i
  %.1735.2.i.i = load double, ptr %.1245.2.i.i, align 8
  %.1787.2.i.i = fsub double %.1735.2.i.i, %.1579.2.i.i
  %.1789.2.i.i = fmul double %.967.i.i, %.1787.2.i.i
  %.1790.2.i.i = fadd double %.1684.2.i.i, %.1789.2.i.i
  %.1795.2.i.i = fmul double %.1790.2.i.i, 5.000000e-01
  %.1796.2.i.i = fadd double %.1579.2.i.i, %.1795.2.i.i
  %.1798.2.i.i = fmul double %sqrt.i38.i, %.1796.2.i.i
  %.1799.2.i.i = fadd double %.1528.2.i.i, %.1798.2.i.i
  store double %.1799.2.i.i, ptr %sunkaddr2.i.i, align 8
  %.2016.i.i = select i1 %.383.i.i, i64 %w13, i64 0
  %.2017.i.i = add i64 %.2016.i.i, %face.2.0.i.i
  %.2037.i.i = mul i64 %.2017.i.i, %w14
  %61 = getelementptr double, ptr %w12, i64 %.2037.i.i
  %.2044.i.i = icmp samesign ult i64 %storemerge.i.fr.i.i, 3
  %.2061.i.i = fmul double %.861.i.i, %.967.i.i
  %.2070.i.i = fsub double 1.000000e+00, %.2061.i.i
  %"$phi998.5.2.2.i.i" = select i1 %.2044.i.i, double %.2061.i.i, double %.2070.i.i
  %.1990.i.i = load double, ptr %sunkaddr3.i.i, align 8
  %.2042.i.i = load double, ptr %61, align 8
  %.2076.i.i = fmul double %"$phi998.5.2.2.i.i", %.2042.i.i
  %.2082.i.i = fadd double %.1990.i.i, %.2076.i.i
  store double %.2082.i.i, ptr %sunkaddr3.i.i, align 8
  %.1990.1.i.i = load double, ptr %sunkaddr4.i.i, align 8
  %62 = getelementptr i8, ptr %61, i64 8
  %.2042.1.i.i = load double, ptr %62, align 8
  %.2076.1.i.i = fmul double %"$phi998.5.2.2.i.i", %.2042.1.i.i
  %.2082.1.i.i = fadd double %.1990.1.i.i, %.2076.1.i.i
  store double %.2082.1.i.i, ptr %sunkaddr4.i.i, align 8
  %.1990.2.i.i = load double, ptr %sunkaddr5.i.i, align 8
  %63 = getelementptr i8, ptr %61, i64 16
  %.2042.2.i.i = load double, ptr %63, align 8
  %.2076.2.i.i = fmul double %"$phi998.5.2.2.i.i", %.2042.2.i.i
  %.2082.2.i.i = fadd double %.1990.2.i.i, %.2076.2.i.i
  store double %.2082.2.i.i, ptr %sunkaddr5.i.i, align 8
  %.1990.3.i.i = load double, ptr %sunkaddr6.i.i, align 8
  %64 = getelementptr i8, ptr %61, i64 24
  %.2042.3.i.i = load double, ptr %64, align 8
  %.2076.3.i.i = fmul double %"$phi998.5.2.2.i.i", %.2042.3.i.i
  %.2082.3.i.i = fadd double %.1990.3.i.i, %.2076.3.i.i
  store double %.2082.3.i.i, ptr %sunkaddr6.i.i, align 8
  %.1990.4.i.i = load double, ptr %sunkaddr7.i.i, align 8
  %65 = getelementptr i8, ptr %61, i64 32
  %.2042.4.i.i = load double, ptr %65, align 8
  %.2076.4.i.i = fmul double %"$phi998.5.2.2.i.i", %.2042.4.i.i
  %.2082.4.i.i = fadd double %.1990.4.i.i, %.2076.4.i.i
  store double %.2082.4.i.i, ptr %sunkaddr7.i.i, align 8
  %.2132.i.i = mul nsw i64 %face.2.0.i.i, 3
  %spec.select.i.i = select i1 %.2044.i.i, i64 %.6791308.zext.i.i, i64 %.4852.zext.i.i
  %.2202.i.i = add nsw i64 %spec.select.i.i, %.2132.i.i
  %.2220.i.i = icmp slt i64 %.2202.i.i, 0
  %.2221.i.i = select i1 %.2220.i.i, i64 %w7, i64 0
  %66 = getelementptr i64, ptr %w6, i64 %.2202.i.i
  %.2235.i.i = getelementptr i64, ptr %66, i64 %.2221.i.i
  %.2236.i.i = load i64, ptr %.2235.i.i, align 8
  %.2257.i.i = sdiv i64 %.2236.i.i, 3
  %.2258.i.i = srem i64 %.2236.i.i, 3
  %.2258.lobit.i.i = ashr i64 %.2258.i.i, 63
  %.2246.1.i.i = add nsw i64 %.2258.lobit.i.i, %.2257.i.i
  %.2295.i.i = icmp slt i64 %.2246.1.i.i, 0
  %.2296.i.i = select i1 %.2295.i.i, i64 %w30, i64 0
  %67 = getelementptr i64, ptr %w29, i64 %.2246.1.i.i
  %.2310.i.i = getelementptr i64, ptr %67, i64 %.2296.i.i
  %.2311.i.i = load i64, ptr %.2310.i.i, align 8
  %.2312.i.i = icmp slt i64 %.2311.i.i, 0
  br i1 %.2312.i.i, label %B104.i.i, label %_ZN7msf_jax4host4thin6fronts12ring_throughB3v45B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx5ArrayIdLi1E1C7mutable7alignedE.exit.i

_ZN7msf_jax4host4thin6fronts12ring_throughB3v45B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1016.i.i, %B1080.i
  %.264578.i = phi double [ 0.000000e+00, %B1080.i ], [ %.2082.i.i, %B1016.i.i ]
  %.2430.i = phi double [ 0.000000e+00, %B1080.i ], [ %.1350.i.i, %B1016.i.i ]
  %.2270.i = load double, ptr %sunkaddr373.i, align 8
  %.2271.i = fcmp ogt double %.2430.i, %.2270.i
  br i1 %.2271.i, label %B1176.preheader.i, label %B1234.lr.ph.i

B1304.i:                                          ; preds = %B738.loopexit.i
  %.2738.i = icmp sgt i64 %rings.2.4.lcssa.i, 1
  br i1 %.2738.i, label %B1320.i, label %B1550.endif.i

B1320.i:                                          ; preds = %B1304.i
  %.2776.i = load double, ptr %.533.i, align 8
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(40) %.451.i, i8 0, i64 40, i1 false)
  br label %B94.endif.i.i

B92.loopexit.i.i:                                 ; preds = %B1179.i.i, %B94.endif.i.i
  %num.4.1.lcssa.i.i = phi i64 [ %num.11.02265.i.i, %B94.endif.i.i ], [ %num.5.2.i.i, %B1179.i.i ]
  %exitcond.not.i41.i = icmp eq i64 %count.2.03906.i, %.438.i.i
  br i1 %exitcond.not.i41.i, label %_ZN7msf_jax4host4thin6fronts7islandsB3v47B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xxd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B94.endif.i.i

B208.i.i:                                         ; preds = %B94.endif.i.i, %B1179.i.i
  %num.4.12218.i.i = phi i64 [ %num.5.2.i.i, %B1179.i.i ], [ %num.11.02265.i.i, %B94.endif.i.i ]
  %.64821772217.i.i = phi i64 [ %.658.i.i, %B1179.i.i ], [ %.605.i.i, %B94.endif.i.i ]
  %.65521782216.i.i = phi i64 [ %.662.i.i, %B1179.i.i ], [ %.536.i.i, %B94.endif.i.i ]
  %.658.i.i = add nsw i64 %.64821772217.i.i, -1
  %.662.i.i = add i64 %.65521782216.i.i, 1
  %.701.i.i = icmp slt i64 %.65521782216.i.i, 0
  %.702.i.i = select i1 %.701.i.i, i64 %w11, i64 0
  %68 = getelementptr i64, ptr %w10, i64 %.65521782216.i.i
  %.716.i.i = getelementptr i64, ptr %68, i64 %.702.i.i
  %.717.i.i = load i64, ptr %.716.i.i, align 8
  %.736.i.i = icmp slt i64 %.717.i.i, 0
  %.737.i.i = select i1 %.736.i.i, i64 %w30, i64 0
  %69 = getelementptr i64, ptr %w29, i64 %.717.i.i
  %.751.i.i = getelementptr i64, ptr %69, i64 %.737.i.i
  %.752.i.i = load i64, ptr %.751.i.i, align 8
  %.753.i.i = icmp slt i64 %.752.i.i, 0
  %.788.i.i = icmp eq i64 %.752.i.i, %longest.3.4.lcssa.i
  %or.cond.i40.i = select i1 %.753.i.i, i1 true, i1 %.788.i.i
  br i1 %or.cond.i40.i, label %B1179.i.i, label %B338.lr.ph.i.i

B400.i.i:                                         ; preds = %B338.lr.ph.i.i
  %sunkaddr.i42.i = shl i64 %.1013.i.i, 3
  %sunkaddr63.i.i = getelementptr inbounds i8, ptr %88, i64 %sunkaddr.i42.i
  store i64 2, ptr %sunkaddr63.i.i, align 8
  %sunkaddr64.i.i = shl i64 %.994.i.i, 3
  %sunkaddr65.i.i = getelementptr i8, ptr %w3, i64 %sunkaddr64.i.i
  %.1169.i.i = load i64, ptr %sunkaddr65.i.i, align 8
  %.1185.i.i = icmp slt i64 %num.4.12218.i.i, 0
  %.1186.i.i = select i1 %.1185.i.i, i64 %w22, i64 0
  %70 = getelementptr i64, ptr %w21, i64 %num.4.12218.i.i
  %.1200.i.i = getelementptr i64, ptr %70, i64 %.1186.i.i
  store i64 %.1169.i.i, ptr %.1200.i.i, align 8
  store i64 %.1169.i.i, ptr %w23, align 8
  %.1235.i.i = add nsw i64 %num.4.12218.i.i, 1
  br label %B532.i.i

B532.i.i:                                         ; preds = %B338.lr.ph.B532_crit_edge.i.i, %B400.i.i
  %sunkaddr66.pre-phi.i.i = phi i64 [ %.pre.i.i, %B338.lr.ph.B532_crit_edge.i.i ], [ %sunkaddr64.i.i, %B400.i.i ]
  %num.12.4.i.i = phi i64 [ %num.4.12218.i.i, %B338.lr.ph.B532_crit_edge.i.i ], [ %.1235.i.i, %B400.i.i ]
  %top.12.4.i.i = phi i64 [ 0, %B338.lr.ph.B532_crit_edge.i.i ], [ 1, %B400.i.i ]
  %sunkaddr67.i.i = getelementptr i8, ptr %w3, i64 %sunkaddr66.pre-phi.i.i
  %sunkaddr68.i.i = getelementptr i8, ptr %sunkaddr67.i.i, i64 8
  %.999.1.i.i = load i64, ptr %sunkaddr68.i.i, align 8
  %.1012.1.i.i = icmp slt i64 %.999.1.i.i, 0
  %.1013.1.i.i = select i1 %.1012.1.i.i, i64 %w18, i64 0
  %71 = getelementptr i64, ptr %w17, i64 %.999.1.i.i
  %.1027.1.i.i = getelementptr i64, ptr %71, i64 %.1013.1.i.i
  %.1028.1.i.i = load i64, ptr %.1027.1.i.i, align 8
  %.1029.1.i.i = icmp eq i64 %.1028.1.i.i, 0
  br i1 %.1029.1.i.i, label %B400.1.i.i, label %B532.1.i.i

B400.1.i.i:                                       ; preds = %B532.i.i
  %sunkaddr69.i.i = shl i64 %.1013.1.i.i, 3
  %sunkaddr70.i.i = getelementptr inbounds i8, ptr %71, i64 %sunkaddr69.i.i
  store i64 2, ptr %sunkaddr70.i.i, align 8
  %.1169.1.i.i = load i64, ptr %sunkaddr68.i.i, align 8
  %.1185.1.i.i = icmp slt i64 %num.12.4.i.i, 0
  %.1186.1.i.i = select i1 %.1185.1.i.i, i64 %w22, i64 0
  %72 = getelementptr i64, ptr %w21, i64 %num.12.4.i.i
  %.1200.1.i.i = getelementptr i64, ptr %72, i64 %.1186.1.i.i
  store i64 %.1169.1.i.i, ptr %.1200.1.i.i, align 8
  %73 = getelementptr i64, ptr %w23, i64 %top.12.4.i.i
  store i64 %.1169.1.i.i, ptr %73, align 8
  %.1235.1.i.i = add nsw i64 %num.12.4.i.i, 1
  %.1239.1.i.i = add nuw nsw i64 %top.12.4.i.i, 1
  br label %B532.1.i.i

B532.1.i.i:                                       ; preds = %B400.1.i.i, %B532.i.i
  %num.12.4.1.i.i = phi i64 [ %.1235.1.i.i, %B400.1.i.i ], [ %num.12.4.i.i, %B532.i.i ]
  %top.12.4.1.i.i = phi i64 [ %.1239.1.i.i, %B400.1.i.i ], [ %top.12.4.i.i, %B532.i.i ]
  %sunkaddr60.i.i = getelementptr i8, ptr %sunkaddr67.i.i, i64 16
  %.999.2.i.i = load i64, ptr %sunkaddr60.i.i, align 8
  %.1012.2.i.i = icmp slt i64 %.999.2.i.i, 0
  %.1013.2.i.i = select i1 %.1012.2.i.i, i64 %w18, i64 0
  %74 = getelementptr i64, ptr %w17, i64 %.999.2.i.i
  %.1027.2.i.i = getelementptr i64, ptr %74, i64 %.1013.2.i.i
  %.1028.2.i.i = load i64, ptr %.1027.2.i.i, align 8
  %.1029.2.i.i = icmp eq i64 %.1028.2.i.i, 0
  br i1 %.1029.2.i.i, label %B532.2.thread.i.i, label %B532.2.i.i

B532.2.thread.i.i:                                ; preds = %B532.1.i.i
  %sunkaddr77.i.i = shl i64 %.1013.2.i.i, 3
  %sunkaddr78.i.i = getelementptr inbounds i8, ptr %74, i64 %sunkaddr77.i.i
  store i64 2, ptr %sunkaddr78.i.i, align 8
  %.1169.2.i.i = load i64, ptr %sunkaddr60.i.i, align 8
  %.1185.2.i.i = icmp slt i64 %num.12.4.1.i.i, 0
  %.1186.2.i.i = select i1 %.1185.2.i.i, i64 %w22, i64 0
  %75 = getelementptr i64, ptr %w21, i64 %num.12.4.1.i.i
  %.1200.2.i.i = getelementptr i64, ptr %75, i64 %.1186.2.i.i
  store i64 %.1169.2.i.i, ptr %.1200.2.i.i, align 8
  %76 = getelementptr i64, ptr %w23, i64 %top.12.4.1.i.i
  store i64 %.1169.2.i.i, ptr %76, align 8
  %.1235.2.i.i = add nsw i64 %num.12.4.1.i.i, 1
  %.1239.2.i.i = add nuw nsw i64 %top.12.4.1.i.i, 1
  br label %B540.endif.i.i.preheader

B540.endif.i.i.preheader:                         ; preds = %B532.2.i.i, %B532.2.thread.i.i
  %num.10.3.i.i.ph = phi i64 [ %num.12.4.1.i.i, %B532.2.i.i ], [ %.1235.2.i.i, %B532.2.thread.i.i ]
  %top.13.3.i.i.ph = phi i64 [ %top.12.4.1.i.i, %B532.2.i.i ], [ %.1239.2.i.i, %B532.2.thread.i.i ]
  br label %B540.endif.i.i

B532.2.i.i:                                       ; preds = %B532.1.i.i
  %.1285.not.i.i = icmp eq i64 %top.12.4.1.i.i, 0
  br i1 %.1285.not.i.i, label %B1179.i.i, label %B540.endif.i.i.preheader

B878.i.i:                                         ; preds = %B878.preheader.new.i.i, %B878.i.i
  %.196822802282.i.i = phi i64 [ 0, %B878.preheader.new.i.i ], [ %.1975.3.i.i, %B878.i.i ]
  %sunkaddr66.i.i = shl i64 %.196822802282.i.i, 3
  %sunkaddr71.i.i = getelementptr i8, ptr %w21, i64 %sunkaddr66.i.i
  %.2032.i.i = load i64, ptr %sunkaddr71.i.i, align 8
  %.2045.i.i = icmp slt i64 %.2032.i.i, 0
  %.2046.i.i = select i1 %.2045.i.i, i64 %w18, i64 0
  %77 = getelementptr i64, ptr %w17, i64 %.2032.i.i
  %.2060.i.i = getelementptr i64, ptr %77, i64 %.2046.i.i
  store i64 0, ptr %.2060.i.i, align 8
  %sunkaddr74.i.i = getelementptr i8, ptr %sunkaddr71.i.i, i64 8
  %.2032.1.i.i = load i64, ptr %sunkaddr74.i.i, align 8
  %.2045.1.i.i = icmp slt i64 %.2032.1.i.i, 0
  %.2046.1.i.i = select i1 %.2045.1.i.i, i64 %w18, i64 0
  %78 = getelementptr i64, ptr %w17, i64 %.2032.1.i.i
  %.2060.1.i.i = getelementptr i64, ptr %78, i64 %.2046.1.i.i
  store i64 0, ptr %.2060.1.i.i, align 8
  %sunkaddr79.i.i = getelementptr i8, ptr %sunkaddr71.i.i, i64 16
  %.2032.2.i.i = load i64, ptr %sunkaddr79.i.i, align 8
  %.2045.2.i.i = icmp slt i64 %.2032.2.i.i, 0
  %.2046.2.i.i = select i1 %.2045.2.i.i, i64 %w18, i64 0
  %79 = getelementptr i64, ptr %w17, i64 %.2032.2.i.i
  %.2060.2.i.i = getelementptr i64, ptr %79, i64 %.2046.2.i.i
  store i64 0, ptr %.2060.2.i.i, align 8
  %.1975.3.i.i = add nuw nsw i64 %.196822802282.i.i, 4
  %sunkaddr82.i.i = getelementptr i8, ptr %sunkaddr71.i.i, i64 24
  %.2032.3.i.i = load i64, ptr %sunkaddr82.i.i, align 8
  %.2045.3.i.i = icmp slt i64 %.2032.3.i.i, 0
  %.2046.3.i.i = select i1 %.2045.3.i.i, i64 %w18, i64 0
  %80 = getelementptr i64, ptr %w17, i64 %.2032.3.i.i
  %.2060.3.i.i = getelementptr i64, ptr %80, i64 %.2046.3.i.i
  store i64 0, ptr %.2060.3.i.i, align 8
  %niter.ncmp.3.i.i = icmp eq i64 %unroll_iter.i.i, %.1975.3.i.i
  br i1 %niter.ncmp.3.i.i, label %common.ret.loopexit.unr-lcssa.i.i, label %B878.i.i

common.ret.loopexit.unr-lcssa.i.i:                ; preds = %B878.i.i
  %lcmp.mod.not.i.i = icmp eq i64 %xtraiter.i.i, 0
  br i1 %lcmp.mod.not.i.i, label %B1550.endif.i, label %B878.epil.preheader.i.i

B878.epil.preheader.i.i:                          ; preds = %B878.preheader.i.i, %common.ret.loopexit.unr-lcssa.i.i
  %.196822802282.epil.init.i.i = phi i64 [ 0, %B878.preheader.i.i ], [ %unroll_iter.i.i, %common.ret.loopexit.unr-lcssa.i.i ]
  %81 = shl i64 %.196822802282.epil.init.i.i, 3
  %scevgep.i.i = getelementptr i8, ptr %w21, i64 %81
  br label %B878.epil.i.i

B878.epil.i.i:                                    ; preds = %B878.epil.i.i, %B878.epil.preheader.i.i
  %epil.iter.i.i = phi i64 [ %epil.iter.next.i.i, %B878.epil.i.i ], [ 0, %B878.epil.preheader.i.i ]
  %82 = shl i64 %epil.iter.i.i, 3
  %scevgep45.i.i = getelementptr i8, ptr %scevgep.i.i, i64 %82
  %.2032.epil.i.i = load i64, ptr %scevgep45.i.i, align 8
  %.2045.epil.i.i = icmp slt i64 %.2032.epil.i.i, 0
  %.2046.epil.i.i = select i1 %.2045.epil.i.i, i64 %w18, i64 0
  %83 = getelementptr i64, ptr %w17, i64 %.2032.epil.i.i
  %.2060.epil.i.i = getelementptr i64, ptr %83, i64 %.2046.epil.i.i
  store i64 0, ptr %.2060.epil.i.i, align 8
  %epil.iter.next.i.i = add i64 %epil.iter.i.i, 1
  %epil.iter.cmp.not.i.i = icmp eq i64 %xtraiter.i.i, %epil.iter.next.i.i
  br i1 %epil.iter.cmp.not.i.i, label %B1550.endif.i, label %B878.epil.i.i

B1164.i.i:                                        ; preds = %B1160.us.2.i.i, %B1160.us.2.peel.i.i, %B540.endif.i.i
  %num.7.5.lcssa.i.i = phi i64 [ %num.10.3.i.i, %B540.endif.i.i ], [ %num.9.7.us.2.peel.i.i, %B1160.us.2.peel.i.i ], [ %num.9.7.us.2.i.i, %B1160.us.2.i.i ]
  %top.8.5.lcssa.i.i = phi i64 [ %.1303.i.i, %B540.endif.i.i ], [ %top.10.7.us.2.peel.i.i, %B1160.us.2.peel.i.i ], [ %top.10.7.us.2.i.i, %B1160.us.2.i.i ]
  %.2562.not.i.i = icmp eq i64 %top.8.5.lcssa.i.i, 0
  br i1 %.2562.not.i.i, label %B1179.i.i, label %B540.endif.i.i

B1179.i.i:                                        ; preds = %B1164.i.i, %B532.2.i.i, %B208.i.i
  %num.5.2.i.i = phi i64 [ %num.4.12218.i.i, %B208.i.i ], [ %num.12.4.1.i.i, %B532.2.i.i ], [ %num.7.5.lcssa.i.i, %B1164.i.i ]
  %.649.i.i = icmp sgt i64 %.64821772217.i.i, 1
  br i1 %.649.i.i, label %B208.i.i, label %B92.loopexit.i.i

B94.endif.i.i:                                    ; preds = %B92.loopexit.i.i, %B1320.i
  %num.11.02265.i.i = phi i64 [ %num.4.1.lcssa.i.i, %B92.loopexit.i.i ], [ 0, %B1320.i ]
  %.43122312263.i.i = phi i64 [ %.438.i.i, %B92.loopexit.i.i ], [ 0, %B1320.i ]
  %.438.i.i = add nuw nsw i64 %.43122312263.i.i, 1
  %84 = getelementptr i64, ptr %w19, i64 %.43122312263.i.i
  %.505.i.i = load i64, ptr %84, align 8
  %.520.i.i = icmp slt i64 %.505.i.i, 0
  %.521.i39.i = select i1 %.520.i.i, i64 %w9, i64 0
  %85 = getelementptr i64, ptr %w8, i64 %.505.i.i
  %.535.i.i = getelementptr i64, ptr %85, i64 %.521.i39.i
  %.536.i.i = load i64, ptr %.535.i.i, align 8
  %.552.i.i = icmp slt i64 %.505.i.i, -1
  %.553.i.i = select i1 %.552.i.i, i64 %w9, i64 0
  %86 = getelementptr i8, ptr %85, i64 8
  %.567.i.i = getelementptr i64, ptr %86, i64 %.553.i.i
  %.568.i.i = load i64, ptr %.567.i.i, align 8
  %.605.i.i = sub i64 %.568.i.i, %.536.i.i
  %.6492207.not.i.i = icmp slt i64 %.605.i.i, 1
  br i1 %.6492207.not.i.i, label %B92.loopexit.i.i, label %B208.i.i

B338.lr.ph.i.i:                                   ; preds = %B208.i.i
  %.973.i.i = select i1 %.736.i.i, i64 %w4, i64 0
  %.974.i.i = add i64 %.973.i.i, %.717.i.i
  %.994.i.i = mul i64 %.974.i.i, %w5
  %87 = getelementptr i64, ptr %w3, i64 %.994.i.i
  %.999.i.i = load i64, ptr %87, align 8
  %.1012.i.i = icmp slt i64 %.999.i.i, 0
  %.1013.i.i = select i1 %.1012.i.i, i64 %w18, i64 0
  %88 = getelementptr i64, ptr %w17, i64 %.999.i.i
  %.1027.i.i = getelementptr i64, ptr %88, i64 %.1013.i.i
  %.1028.i.i = load i64, ptr %.1027.i.i, align 8
  %.1029.i.i = icmp eq i64 %.1028.i.i, 0
  br i1 %.1029.i.i, label %B400.i.i, label %B338.lr.ph.B532_crit_edge.i.i

B338.lr.ph.B532_crit_edge.i.i:                    ; preds = %B338.lr.ph.i.i
  %.pre.i.i = shl i64 %.994.i.i, 3
  br label %B532.i.i

B540.endif.i.i:                                   ; preds = %B540.endif.i.i.preheader, %B1164.i.i
  %num.10.3.i.i = phi i64 [ %num.7.5.lcssa.i.i, %B1164.i.i ], [ %num.10.3.i.i.ph, %B540.endif.i.i.preheader ]
  %top.13.3.i.i = phi i64 [ %top.8.5.lcssa.i.i, %B1164.i.i ], [ %top.13.3.i.i.ph, %B540.endif.i.i.preheader ]
  %.1303.i.i = add nsw i64 %top.13.3.i.i, -1
  %.1323.inv.i.i = icmp sgt i64 %top.13.3.i.i, 0
  %.1324.i.i = select i1 %.1323.inv.i.i, i64 0, i64 %w24
  %89 = getelementptr i64, ptr %w23, i64 %.1303.i.i
  %.1338.i.i = getelementptr i64, ptr %89, i64 %.1324.i.i
  %.1339.i.i = load i64, ptr %.1338.i.i, align 8
  %.1354.i.i = icmp slt i64 %.1339.i.i, 0
  %.1355.i.i = select i1 %.1354.i.i, i64 %w9, i64 0
  %90 = getelementptr i64, ptr %w8, i64 %.1339.i.i
  %.1369.i.i = getelementptr i64, ptr %90, i64 %.1355.i.i
  %.1370.i.i = load i64, ptr %.1369.i.i, align 8
  %.1386.i.i = icmp slt i64 %.1339.i.i, -1
  %.1387.i.i = select i1 %.1386.i.i, i64 %w9, i64 0
  %91 = getelementptr i8, ptr %90, i64 8
  %.1401.i.i = getelementptr i64, ptr %91, i64 %.1387.i.i
  %.1402.i.i = load i64, ptr %.1401.i.i, align 8
  %.1439.i.i = sub i64 %.1402.i.i, %.1370.i.i
  %.14822002.not.i.i = icmp slt i64 %.1439.i.i, 1
  br i1 %.14822002.not.i.i, label %B1164.i.i, label %B660.endif.endif.us.preheader.i.i

B660.endif.endif.us.preheader.i.i:                ; preds = %B540.endif.i.i
  %.1534.us.peel.i.i = icmp slt i64 %.1370.i.i, 0
  %.1535.us.peel.i.i = select i1 %.1534.us.peel.i.i, i64 %w11, i64 0
  %92 = getelementptr i64, ptr %w10, i64 %.1370.i.i
  %.1549.us.peel.i.i = getelementptr i64, ptr %92, i64 %.1535.us.peel.i.i
  %.1550.us.peel.i.i = load i64, ptr %.1549.us.peel.i.i, align 8
  %.1725.us.peel.i.i = icmp slt i64 %.1550.us.peel.i.i, 0
  %.1726.us.peel.i.i = select i1 %.1725.us.peel.i.i, i64 %w13, i64 0
  %.1727.us.peel.i.i = add i64 %.1726.us.peel.i.i, %.1550.us.peel.i.i
  %.1747.us.peel.i.i = mul i64 %.1727.us.peel.i.i, %w14
  %93 = getelementptr double, ptr %w12, i64 %.1747.us.peel.i.i
  %.1700.us.peel.i.i = load double, ptr %.451.i, align 8
  %.1752.us.peel.i.i = load double, ptr %93, align 8
  %.1757.us.peel.i.i = fdiv double %.1752.us.peel.i.i, 3.000000e+00
  %.1758.us.peel.i.i = fadd double %.1700.us.peel.i.i, %.1757.us.peel.i.i
  store double %.1758.us.peel.i.i, ptr %.451.i, align 8
  %.1700.us.1.peel.i.i = load double, ptr %sunkaddr83.i.i, align 8
  %94 = getelementptr i8, ptr %93, i64 8
  %.1752.us.1.peel.i.i = load double, ptr %94, align 8
  %.1757.us.1.peel.i.i = fdiv double %.1752.us.1.peel.i.i, 3.000000e+00
  %.1758.us.1.peel.i.i = fadd double %.1700.us.1.peel.i.i, %.1757.us.1.peel.i.i
  store double %.1758.us.1.peel.i.i, ptr %sunkaddr83.i.i, align 8
  %.1700.us.2.peel.i.i = load double, ptr %sunkaddr84.i.i, align 8
  %95 = getelementptr i8, ptr %93, i64 16
  %.1752.us.2.peel.i.i = load double, ptr %95, align 8
  %.1757.us.2.peel.i.i = fdiv double %.1752.us.2.peel.i.i, 3.000000e+00
  %.1758.us.2.peel.i.i = fadd double %.1700.us.2.peel.i.i, %.1757.us.2.peel.i.i
  store double %.1758.us.2.peel.i.i, ptr %sunkaddr84.i.i, align 8
  %.1700.us.3.peel.i.i = load double, ptr %sunkaddr85.i.i, align 8
  %96 = getelementptr i8, ptr %93, i64 24
  %.1752.us.3.peel.i.i = load double, ptr %96, align 8
  %.1757.us.3.peel.i.i = fdiv double %.1752.us.3.peel.i.i, 3.000000e+00
  %.1758.us.3.peel.i.i = fadd double %.1700.us.3.peel.i.i, %.1757.us.3.peel.i.i
  store double %.1758.us.3.peel.i.i, ptr %sunkaddr85.i.i, align 8
  %.1700.us.4.peel.i.i = load double, ptr %sunkaddr86.i.i, align 8
  %97 = getelementptr i8, ptr %93, i64 32
  %.1752.us.4.peel.i.i = load double, ptr %97, align 8
  %.1757.us.4.peel.i.i = fdiv double %.1752.us.4.peel.i.i, 3.000000e+00
  %.1758.us.4.peel.i.i = fadd double %.1700.us.4.peel.i.i, %.1757.us.4.peel.i.i
  store double %.1758.us.4.peel.i.i, ptr %sunkaddr86.i.i, align 8
  %.1810.us.peel.i.i = select i1 %.1725.us.peel.i.i, i64 %w30, i64 0
  %98 = getelementptr i64, ptr %w29, i64 %.1550.us.peel.i.i
  %.1824.us.peel.i.i = getelementptr i64, ptr %98, i64 %.1810.us.peel.i.i
  %.1825.us.peel.i.i = load i64, ptr %.1824.us.peel.i.i, align 8
  %.1827.us.peel.i.i = icmp eq i64 %.1825.us.peel.i.i, %longest.3.4.lcssa.i
  %.1860.us.peel.i.i = fcmp ogt double %.1758.us.peel.i.i, %.2776.i
  %or.cond2364.i.i = select i1 %.1827.us.peel.i.i, i1 true, i1 %.1860.us.peel.i.i
  br i1 %or.cond2364.i.i, label %B846.endif.split.us.i.i, label %B934.endif.endif.us.peel.i.i

B934.endif.endif.us.peel.i.i:                     ; preds = %B660.endif.endif.us.preheader.i.i
  %.2239.us.peel.i.i = select i1 %.1725.us.peel.i.i, i64 %w4, i64 0
  %.2240.us.peel.i.i = add i64 %.2239.us.peel.i.i, %.1550.us.peel.i.i
  %.2260.us.peel.i.i = mul i64 %.2240.us.peel.i.i, %w5
  %99 = getelementptr i64, ptr %w3, i64 %.2260.us.peel.i.i
  %.2265.us.peel.i.i = load i64, ptr %99, align 8
  %.2278.us.peel.i.i = icmp slt i64 %.2265.us.peel.i.i, 0
  %.2279.us.peel.i.i = select i1 %.2278.us.peel.i.i, i64 %w18, i64 0
  %100 = getelementptr i64, ptr %w17, i64 %.2265.us.peel.i.i
  %.2293.us.peel.i.i = getelementptr i64, ptr %100, i64 %.2279.us.peel.i.i
  %.2294.us.peel.i.i = load i64, ptr %.2293.us.peel.i.i, align 8
  %.2295.us.peel.i.i = icmp eq i64 %.2294.us.peel.i.i, 0
  br i1 %.2295.us.peel.i.i, label %B1028.us.peel.i.i, label %B934.endif.endif.us.peel.B1160.us.peel_crit_edge.i.i

B934.endif.endif.us.peel.B1160.us.peel_crit_edge.i.i: ; preds = %B934.endif.endif.us.peel.i.i
  %.pre19.i.i = shl i64 %.2260.us.peel.i.i, 3
  br label %B1160.us.peel.i.i

B1028.us.peel.i.i:                                ; preds = %B934.endif.endif.us.peel.i.i
  %sunkaddr97.i.i = shl i64 %.2279.us.peel.i.i, 3
  %sunkaddr98.i.i = getelementptr inbounds i8, ptr %100, i64 %sunkaddr97.i.i
  store i64 2, ptr %sunkaddr98.i.i, align 8
  %sunkaddr99.i.i = shl i64 %.2260.us.peel.i.i, 3
  %sunkaddr100.i.i = getelementptr i8, ptr %w3, i64 %sunkaddr99.i.i
  %.2435.us.peel.i.i = load i64, ptr %sunkaddr100.i.i, align 8
  %.2451.us.peel.i.i = icmp slt i64 %num.10.3.i.i, 0
  %.2452.us.peel.i.i = select i1 %.2451.us.peel.i.i, i64 %w22, i64 0
  %101 = getelementptr i64, ptr %w21, i64 %num.10.3.i.i
  %.2466.us.peel.i.i = getelementptr i64, ptr %101, i64 %.2452.us.peel.i.i
  store i64 %.2435.us.peel.i.i, ptr %.2466.us.peel.i.i, align 8
  %sunkaddr101.i.i = shl i64 %.1324.i.i, 3
  %sunkaddr102.i.i = getelementptr inbounds i8, ptr %89, i64 %sunkaddr101.i.i
  store i64 %.2435.us.peel.i.i, ptr %sunkaddr102.i.i, align 8
  %.2501.us.peel.i.i = add nsw i64 %num.10.3.i.i, 1
  br label %B1160.us.peel.i.i

B1160.us.peel.i.i:                                ; preds = %B1028.us.peel.i.i, %B934.endif.endif.us.peel.B1160.us.peel_crit_edge.i.i
  %sunkaddr103.pre-phi.i.i = phi i64 [ %.pre19.i.i, %B934.endif.endif.us.peel.B1160.us.peel_crit_edge.i.i ], [ %sunkaddr99.i.i, %B1028.us.peel.i.i ]
  %num.9.7.us.peel.i.i = phi i64 [ %num.10.3.i.i, %B934.endif.endif.us.peel.B1160.us.peel_crit_edge.i.i ], [ %.2501.us.peel.i.i, %B1028.us.peel.i.i ]
  %top.10.7.us.peel.i.i = phi i64 [ %.1303.i.i, %B934.endif.endif.us.peel.B1160.us.peel_crit_edge.i.i ], [ %top.13.3.i.i, %B1028.us.peel.i.i ]
  %sunkaddr104.i.i = getelementptr i8, ptr %w3, i64 %sunkaddr103.pre-phi.i.i
  %sunkaddr105.i.i = getelementptr i8, ptr %sunkaddr104.i.i, i64 8
  %.2265.us.1.peel.i.i = load i64, ptr %sunkaddr105.i.i, align 8
  %.2278.us.1.peel.i.i = icmp slt i64 %.2265.us.1.peel.i.i, 0
  %.2279.us.1.peel.i.i = select i1 %.2278.us.1.peel.i.i, i64 %w18, i64 0
  %102 = getelementptr i64, ptr %w17, i64 %.2265.us.1.peel.i.i
  %.2293.us.1.peel.i.i = getelementptr i64, ptr %102, i64 %.2279.us.1.peel.i.i
  %.2294.us.1.peel.i.i = load i64, ptr %.2293.us.1.peel.i.i, align 8
  %.2295.us.1.peel.i.i = icmp eq i64 %.2294.us.1.peel.i.i, 0
  br i1 %.2295.us.1.peel.i.i, label %B1028.us.1.peel.i.i, label %B1160.us.1.peel.i.i

B1028.us.1.peel.i.i:                              ; preds = %B1160.us.peel.i.i
  %sunkaddr106.i.i = shl i64 %.2279.us.1.peel.i.i, 3
  %sunkaddr107.i.i = getelementptr inbounds i8, ptr %102, i64 %sunkaddr106.i.i
  store i64 2, ptr %sunkaddr107.i.i, align 8
  %.2435.us.1.peel.i.i = load i64, ptr %sunkaddr105.i.i, align 8
  %.2451.us.1.peel.i.i = icmp slt i64 %num.9.7.us.peel.i.i, 0
  %.2452.us.1.peel.i.i = select i1 %.2451.us.1.peel.i.i, i64 %w22, i64 0
  %103 = getelementptr i64, ptr %w21, i64 %num.9.7.us.peel.i.i
  %.2466.us.1.peel.i.i = getelementptr i64, ptr %103, i64 %.2452.us.1.peel.i.i
  store i64 %.2435.us.1.peel.i.i, ptr %.2466.us.1.peel.i.i, align 8
  %.2483.us.1.peel.i.i = icmp slt i64 %top.10.7.us.peel.i.i, 0
  %.2484.us.1.peel.i.i = select i1 %.2483.us.1.peel.i.i, i64 %w24, i64 0
  %104 = getelementptr i64, ptr %w23, i64 %top.10.7.us.peel.i.i
  %.2498.us.1.peel.i.i = getelementptr i64, ptr %104, i64 %.2484.us.1.peel.i.i
  store i64 %.2435.us.1.peel.i.i, ptr %.2498.us.1.peel.i.i, align 8
  %.2501.us.1.peel.i.i = add nsw i64 %num.9.7.us.peel.i.i, 1
  %.2505.us.1.peel.i.i = add nsw i64 %top.10.7.us.peel.i.i, 1
  br label %B1160.us.1.peel.i.i

B1160.us.1.peel.i.i:                              ; preds = %B1028.us.1.peel.i.i, %B1160.us.peel.i.i
  %num.9.7.us.1.peel.i.i = phi i64 [ %.2501.us.1.peel.i.i, %B1028.us.1.peel.i.i ], [ %num.9.7.us.peel.i.i, %B1160.us.peel.i.i ]
  %top.10.7.us.1.peel.i.i = phi i64 [ %.2505.us.1.peel.i.i, %B1028.us.1.peel.i.i ], [ %top.10.7.us.peel.i.i, %B1160.us.peel.i.i ]
  %sunkaddr90.i.i = getelementptr i8, ptr %sunkaddr104.i.i, i64 16
  %.2265.us.2.peel.i.i = load i64, ptr %sunkaddr90.i.i, align 8
  %.2278.us.2.peel.i.i = icmp slt i64 %.2265.us.2.peel.i.i, 0
  %.2279.us.2.peel.i.i = select i1 %.2278.us.2.peel.i.i, i64 %w18, i64 0
  %105 = getelementptr i64, ptr %w17, i64 %.2265.us.2.peel.i.i
  %.2293.us.2.peel.i.i = getelementptr i64, ptr %105, i64 %.2279.us.2.peel.i.i
  %.2294.us.2.peel.i.i = load i64, ptr %.2293.us.2.peel.i.i, align 8
  %.2295.us.2.peel.i.i = icmp eq i64 %.2294.us.2.peel.i.i, 0
  br i1 %.2295.us.2.peel.i.i, label %B1028.us.2.peel.i.i, label %B1160.us.2.peel.i.i

B1028.us.2.peel.i.i:                              ; preds = %B1160.us.1.peel.i.i
  %sunkaddr114.i.i = shl i64 %.2279.us.2.peel.i.i, 3
  %sunkaddr115.i.i = getelementptr inbounds i8, ptr %105, i64 %sunkaddr114.i.i
  store i64 2, ptr %sunkaddr115.i.i, align 8
  %.2435.us.2.peel.i.i = load i64, ptr %sunkaddr90.i.i, align 8
  %.2451.us.2.peel.i.i = icmp slt i64 %num.9.7.us.1.peel.i.i, 0
  %.2452.us.2.peel.i.i = select i1 %.2451.us.2.peel.i.i, i64 %w22, i64 0
  %106 = getelementptr i64, ptr %w21, i64 %num.9.7.us.1.peel.i.i
  %.2466.us.2.peel.i.i = getelementptr i64, ptr %106, i64 %.2452.us.2.peel.i.i
  store i64 %.2435.us.2.peel.i.i, ptr %.2466.us.2.peel.i.i, align 8
  %.2483.us.2.peel.i.i = icmp slt i64 %top.10.7.us.1.peel.i.i, 0
  %.2484.us.2.peel.i.i = select i1 %.2483.us.2.peel.i.i, i64 %w24, i64 0
  %107 = getelementptr i64, ptr %w23, i64 %top.10.7.us.1.peel.i.i
  %.2498.us.2.peel.i.i = getelementptr i64, ptr %107, i64 %.2484.us.2.peel.i.i
  store i64 %.2435.us.2.peel.i.i, ptr %.2498.us.2.peel.i.i, align 8
  %.2501.us.2.peel.i.i = add nsw i64 %num.9.7.us.1.peel.i.i, 1
  %.2505.us.2.peel.i.i = add nsw i64 %top.10.7.us.1.peel.i.i, 1
  br label %B1160.us.2.peel.i.i

B1160.us.2.peel.i.i:                              ; preds = %B1028.us.2.peel.i.i, %B1160.us.1.peel.i.i
  %num.9.7.us.2.peel.i.i = phi i64 [ %.2501.us.2.peel.i.i, %B1028.us.2.peel.i.i ], [ %num.9.7.us.1.peel.i.i, %B1160.us.1.peel.i.i ]
  %top.10.7.us.2.peel.i.i = phi i64 [ %.2505.us.2.peel.i.i, %B1028.us.2.peel.i.i ], [ %top.10.7.us.1.peel.i.i, %B1160.us.1.peel.i.i ]
  %.1482.us.peel.not.i.i = icmp eq i64 %.1439.i.i, 1
  br i1 %.1482.us.peel.not.i.i, label %B1164.i.i, label %B660.endif.endif.us.preheader47.i.i

B660.endif.endif.us.preheader47.i.i:              ; preds = %B1160.us.2.peel.i.i
  %108 = add nuw i64 %.1439.i.i, 1
  br label %B660.endif.endif.us.i.i

B660.endif.endif.us.i.i:                          ; preds = %B1160.us.2.i.i, %B660.endif.endif.us.preheader47.i.i
  %lsr.iv54.in.i.i = phi i64 [ %lsr.iv54.i.i, %B1160.us.2.i.i ], [ %.1370.i.i, %B660.endif.endif.us.preheader47.i.i ]
  %lsr.iv.i.i = phi i64 [ %lsr.iv.next.i.i, %B1160.us.2.i.i ], [ %108, %B660.endif.endif.us.preheader47.i.i ]
  %top.8.52008.us.i.i = phi i64 [ %top.10.7.us.2.i.i, %B1160.us.2.i.i ], [ %top.10.7.us.2.peel.i.i, %B660.endif.endif.us.preheader47.i.i ]
  %num.7.52007.us.i.i = phi i64 [ %num.9.7.us.2.i.i, %B1160.us.2.i.i ], [ %num.9.7.us.2.peel.i.i, %B660.endif.endif.us.preheader47.i.i ]
  %lsr.iv54.i.i = add i64 %lsr.iv54.in.i.i, 1
  %.1534.us.i.i = icmp slt i64 %lsr.iv54.i.i, 0
  %109 = select i1 %.1534.us.i.i, i64 %3, i64 0
  %scevgep61.i.i = getelementptr i8, ptr %w10, i64 %109
  %110 = shl i64 %lsr.iv54.i.i, 3
  %scevgep56.i.i = getelementptr i8, ptr %scevgep61.i.i, i64 %110
  %.1550.us.i.i = load i64, ptr %scevgep56.i.i, align 8
  %.1725.us.i.i = icmp slt i64 %.1550.us.i.i, 0
  %.1726.us.i.i = select i1 %.1725.us.i.i, i64 %w13, i64 0
  %.1727.us.i.i = add i64 %.1726.us.i.i, %.1550.us.i.i
  %.1747.us.i.i = mul i64 %.1727.us.i.i, %w14
  %111 = getelementptr double, ptr %w12, i64 %.1747.us.i.i
  %.1700.us.i.i = load double, ptr %.451.i, align 8
  %.1752.us.i.i = load double, ptr %111, align 8
  %.1757.us.i.i = fdiv double %.1752.us.i.i, 3.000000e+00
  %.1758.us.i.i = fadd double %.1700.us.i.i, %.1757.us.i.i
  store double %.1758.us.i.i, ptr %.451.i, align 8
  %.1700.us.1.i.i = load double, ptr %sunkaddr83.i.i, align 8
  %112 = getelementptr i8, ptr %111, i64 8
  %.1752.us.1.i.i = load double, ptr %112, align 8
  %.1757.us.1.i.i = fdiv double %.1752.us.1.i.i, 3.000000e+00
  %.1758.us.1.i.i = fadd double %.1700.us.1.i.i, %.1757.us.1.i.i
  store double %.1758.us.1.i.i, ptr %sunkaddr83.i.i, align 8
  %.1700.us.2.i.i = load double, ptr %sunkaddr84.i.i, align 8
  %113 = getelementptr i8, ptr %111, i64 16
  %.1752.us.2.i.i = load double, ptr %113, align 8
  %.1757.us.2.i.i = fdiv double %.1752.us.2.i.i, 3.000000e+00
  %.1758.us.2.i.i = fadd double %.1700.us.2.i.i, %.1757.us.2.i.i
  store double %.1758.us.2.i.i, ptr %sunkaddr84.i.i, align 8
  %.1700.us.3.i.i = load double, ptr %sunkaddr85.i.i, align 8
  %114 = getelementptr i8, ptr %111, i64 24
  %.1752.us.3.i.i = load double, ptr %114, align 8
  %.1757.us.3.i.i = fdiv double %.1752.us.3.i.i, 3.000000e+00
  %.1758.us.3.i.i = fadd double %.1700.us.3.i.i, %.1757.us.3.i.i
  store double %.1758.us.3.i.i, ptr %sunkaddr85.i.i, align 8
  %.1700.us.4.i.i = load double, ptr %sunkaddr86.i.i, align 8
  %115 = getelementptr i8, ptr %111, i64 32
  %.1752.us.4.i.i = load double, ptr %115, align 8
  %.1757.us.4.i.i = fdiv double %.1752.us.4.i.i, 3.000000e+00
  %.1758.us.4.i.i = fadd double %.1700.us.4.i.i, %.1757.us.4.i.i
  store double %.1758.us.4.i.i, ptr %sunkaddr86.i.i, align 8
  %.1810.us.i.i = select i1 %.1725.us.i.i, i64 %w30, i64 0
  %116 = getelementptr i64, ptr %w29, i64 %.1550.us.i.i
  %.1824.us.i.i = getelementptr i64, ptr %116, i64 %.1810.us.i.i
  %.1825.us.i.i = load i64, ptr %.1824.us.i.i, align 8
  %.1827.us.i.i = icmp eq i64 %.1825.us.i.i, %longest.3.4.lcssa.i
  %.1860.us.i.i = fcmp ogt double %.1758.us.i.i, %.2776.i
  %or.cond2365.i.i = select i1 %.1827.us.i.i, i1 true, i1 %.1860.us.i.i
  br i1 %or.cond2365.i.i, label %B846.endif.split.us.i.i, label %B934.endif.endif.us.i.i

B934.endif.endif.us.i.i:                          ; preds = %B660.endif.endif.us.i.i
  %.2239.us.i.i = select i1 %.1725.us.i.i, i64 %w4, i64 0
  %.2240.us.i.i = add i64 %.2239.us.i.i, %.1550.us.i.i
  %.2260.us.i.i = mul i64 %.2240.us.i.i, %w5
  %117 = getelementptr i64, ptr %w3, i64 %.2260.us.i.i
  %.2265.us.i.i = load i64, ptr %117, align 8
  %.2278.us.i.i = icmp slt i64 %.2265.us.i.i, 0
  %.2279.us.i.i = select i1 %.2278.us.i.i, i64 %w18, i64 0
  %118 = getelementptr i64, ptr %w17, i64 %.2265.us.i.i
  %.2293.us.i.i = getelementptr i64, ptr %118, i64 %.2279.us.i.i
  %.2294.us.i.i = load i64, ptr %.2293.us.i.i, align 8
  %.2295.us.i.i = icmp eq i64 %.2294.us.i.i, 0
  br i1 %.2295.us.i.i, label %B1028.us.i.i, label %B934.endif.endif.us.B1160.us_crit_edge.i.i

B934.endif.endif.us.B1160.us_crit_edge.i.i:       ; preds = %B934.endif.endif.us.i.i
  %.pre20.i.i = shl i64 %.2260.us.i.i, 3
  br label %B1160.us.i.i

B1028.us.i.i:                                     ; preds = %B934.endif.endif.us.i.i
  %sunkaddr123.i.i = shl i64 %.2279.us.i.i, 3
  %sunkaddr124.i.i = getelementptr inbounds i8, ptr %118, i64 %sunkaddr123.i.i
  store i64 2, ptr %sunkaddr124.i.i, align 8
  %sunkaddr125.i.i = shl i64 %.2260.us.i.i, 3
  %sunkaddr126.i.i = getelementptr i8, ptr %w3, i64 %sunkaddr125.i.i
  %.2435.us.i.i = load i64, ptr %sunkaddr126.i.i, align 8
  %.2451.us.i.i = icmp slt i64 %num.7.52007.us.i.i, 0
  %.2452.us.i.i = select i1 %.2451.us.i.i, i64 %w22, i64 0
  %119 = getelementptr i64, ptr %w21, i64 %num.7.52007.us.i.i
  %.2466.us.i.i = getelementptr i64, ptr %119, i64 %.2452.us.i.i
  store i64 %.2435.us.i.i, ptr %.2466.us.i.i, align 8
  %.2483.us.i.i = icmp slt i64 %top.8.52008.us.i.i, 0
  %.2484.us.i.i = select i1 %.2483.us.i.i, i64 %w24, i64 0
  %120 = getelementptr i64, ptr %w23, i64 %top.8.52008.us.i.i
  %.2498.us.i.i = getelementptr i64, ptr %120, i64 %.2484.us.i.i
  store i64 %.2435.us.i.i, ptr %.2498.us.i.i, align 8
  %.2501.us.i.i = add nsw i64 %num.7.52007.us.i.i, 1
  %.2505.us.i.i = add nsw i64 %top.8.52008.us.i.i, 1
  br label %B1160.us.i.i

B1160.us.i.i:                                     ; preds = %B1028.us.i.i, %B934.endif.endif.us.B1160.us_crit_edge.i.i
  %sunkaddr127.pre-phi.i.i = phi i64 [ %.pre20.i.i, %B934.endif.endif.us.B1160.us_crit_edge.i.i ], [ %sunkaddr125.i.i, %B1028.us.i.i ]
  %num.9.7.us.i.i = phi i64 [ %num.7.52007.us.i.i, %B934.endif.endif.us.B1160.us_crit_edge.i.i ], [ %.2501.us.i.i, %B1028.us.i.i ]
  %top.10.7.us.i.i = phi i64 [ %top.8.52008.us.i.i, %B934.endif.endif.us.B1160.us_crit_edge.i.i ], [ %.2505.us.i.i, %B1028.us.i.i ]
  %sunkaddr128.i.i = getelementptr i8, ptr %w3, i64 %sunkaddr127.pre-phi.i.i
  %sunkaddr129.i.i = getelementptr i8, ptr %sunkaddr128.i.i, i64 8
  %.2265.us.1.i.i = load i64, ptr %sunkaddr129.i.i, align 8
  %.2278.us.1.i.i = icmp slt i64 %.2265.us.1.i.i, 0
  %.2279.us.1.i.i = select i1 %.2278.us.1.i.i, i64 %w18, i64 0
  %121 = getelementptr i64, ptr %w17, i64 %.2265.us.1.i.i
  %.2293.us.1.i.i = getelementptr i64, ptr %121, i64 %.2279.us.1.i.i
  %.2294.us.1.i.i = load i64, ptr %.2293.us.1.i.i, align 8
  %.2295.us.1.i.i = icmp eq i64 %.2294.us.1.i.i, 0
  br i1 %.2295.us.1.i.i, label %B1028.us.1.i.i, label %B1160.us.1.i.i

B1028.us.1.i.i:                                   ; preds = %B1160.us.i.i
  %sunkaddr130.i.i = shl i64 %.2279.us.1.i.i, 3
  %sunkaddr131.i.i = getelementptr inbounds i8, ptr %121, i64 %sunkaddr130.i.i
  store i64 2, ptr %sunkaddr131.i.i, align 8
  %.2435.us.1.i.i = load i64, ptr %sunkaddr129.i.i, align 8
  %.2451.us.1.i.i = icmp slt i64 %num.9.7.us.i.i, 0
  %.2452.us.1.i.i = select i1 %.2451.us.1.i.i, i64 %w22, i64 0
  %122 = getelementptr i64, ptr %w21, i64 %num.9.7.us.i.i
  %.2466.us.1.i.i = getelementptr i64, ptr %122, i64 %.2452.us.1.i.i
  store i64 %.2435.us.1.i.i, ptr %.2466.us.1.i.i, align 8
  %.2483.us.1.i.i = icmp slt i64 %top.10.7.us.i.i, 0
  %.2484.us.1.i.i = select i1 %.2483.us.1.i.i, i64 %w24, i64 0
  %123 = getelementptr i64, ptr %w23, i64 %top.10.7.us.i.i
  %.2498.us.1.i.i = getelementptr i64, ptr %123, i64 %.2484.us.1.i.i
  store i64 %.2435.us.1.i.i, ptr %.2498.us.1.i.i, align 8
  %.2501.us.1.i.i = add nsw i64 %num.9.7.us.i.i, 1
  %.2505.us.1.i.i = add nsw i64 %top.10.7.us.i.i, 1
  br label %B1160.us.1.i.i

B1160.us.1.i.i:                                   ; preds = %B1028.us.1.i.i, %B1160.us.i.i
  %num.9.7.us.1.i.i = phi i64 [ %.2501.us.1.i.i, %B1028.us.1.i.i ], [ %num.9.7.us.i.i, %B1160.us.i.i ]
  %top.10.7.us.1.i.i = phi i64 [ %.2505.us.1.i.i, %B1028.us.1.i.i ], [ %top.10.7.us.i.i, %B1160.us.i.i ]
  %sunkaddr116.i.i = getelementptr i8, ptr %sunkaddr128.i.i, i64 16
  %.2265.us.2.i.i = load i64, ptr %sunkaddr116.i.i, align 8
  %.2278.us.2.i.i = icmp slt i64 %.2265.us.2.i.i, 0
  %.2279.us.2.i.i = select i1 %.2278.us.2.i.i, i64 %w18, i64 0
  %124 = getelementptr i64, ptr %w17, i64 %.2265.us.2.i.i
  %.2293.us.2.i.i = getelementptr i64, ptr %124, i64 %.2279.us.2.i.i
  %.2294.us.2.i.i = load i64, ptr %.2293.us.2.i.i, align 8
  %.2295.us.2.i.i = icmp eq i64 %.2294.us.2.i.i, 0
  br i1 %.2295.us.2.i.i, label %B1028.us.2.i.i, label %B1160.us.2.i.i

B1028.us.2.i.i:                                   ; preds = %B1160.us.1.i.i
  %sunkaddr138.i.i = shl i64 %.2279.us.2.i.i, 3
  %sunkaddr139.i.i = getelementptr inbounds i8, ptr %124, i64 %sunkaddr138.i.i
  store i64 2, ptr %sunkaddr139.i.i, align 8
  %.2435.us.2.i.i = load i64, ptr %sunkaddr116.i.i, align 8
  %.2451.us.2.i.i = icmp slt i64 %num.9.7.us.1.i.i, 0
  %.2452.us.2.i.i = select i1 %.2451.us.2.i.i, i64 %w22, i64 0
  %125 = getelementptr i64, ptr %w21, i64 %num.9.7.us.1.i.i
  %.2466.us.2.i.i = getelementptr i64, ptr %125, i64 %.2452.us.2.i.i
  store i64 %.2435.us.2.i.i, ptr %.2466.us.2.i.i, align 8
  %.2483.us.2.i.i = icmp slt i64 %top.10.7.us.1.i.i, 0
  %.2484.us.2.i.i = select i1 %.2483.us.2.i.i, i64 %w24, i64 0
  %126 = getelementptr i64, ptr %w23, i64 %top.10.7.us.1.i.i
  %.2498.us.2.i.i = getelementptr i64, ptr %126, i64 %.2484.us.2.i.i
  store i64 %.2435.us.2.i.i, ptr %.2498.us.2.i.i, align 8
  %.2501.us.2.i.i = add nsw i64 %num.9.7.us.1.i.i, 1
  %.2505.us.2.i.i = add nsw i64 %top.10.7.us.1.i.i, 1
  br label %B1160.us.2.i.i

B1160.us.2.i.i:                                   ; preds = %B1028.us.2.i.i, %B1160.us.1.i.i
  %num.9.7.us.2.i.i = phi i64 [ %.2501.us.2.i.i, %B1028.us.2.i.i ], [ %num.9.7.us.1.i.i, %B1160.us.1.i.i ]
  %top.10.7.us.2.i.i = phi i64 [ %.2505.us.2.i.i, %B1028.us.2.i.i ], [ %top.10.7.us.1.i.i, %B1160.us.1.i.i ]
  %lsr.iv.next.i.i = add i64 %lsr.iv.i.i, -1
  %.1482.us.i.i = icmp samesign ugt i64 %lsr.iv.next.i.i, 2
  br i1 %.1482.us.i.i, label %B660.endif.endif.us.i.i, label %B1164.i.i

B846.endif.split.us.i.i:                          ; preds = %B660.endif.endif.us.preheader.i.i, %B660.endif.endif.us.i.i
  %num.7.52007.us.lcssa.i.i = phi i64 [ %num.7.52007.us.i.i, %B660.endif.endif.us.i.i ], [ %num.10.3.i.i, %B660.endif.endif.us.preheader.i.i ]
  %.19622281.not.i.i = icmp slt i64 %num.7.52007.us.lcssa.i.i, 1
  br i1 %.19622281.not.i.i, label %B1550.endif.i, label %B878.preheader.i.i

B878.preheader.i.i:                               ; preds = %B846.endif.split.us.i.i
  %xtraiter.i.i = and i64 %num.7.52007.us.lcssa.i.i, 3
  %127 = icmp samesign ult i64 %num.7.52007.us.lcssa.i.i, 4
  br i1 %127, label %B878.epil.preheader.i.i, label %B878.preheader.new.i.i

B878.preheader.new.i.i:                           ; preds = %B878.preheader.i.i
  %unroll_iter.i.i = and i64 %num.7.52007.us.lcssa.i.i, 9223372036854775804
  br label %B878.i.i

_ZN7msf_jax4host4thin6fronts7islandsB3v47B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xxd5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B92.loopexit.i.i
  %.2848.i = icmp sgt i64 %num.4.1.lcssa.i.i, 0
  br i1 %.2848.i, label %B1496.preheader.i, label %B1550.endif.i

B1496.i:                                          ; preds = %B1496.preheader.new.i, %B1546.1.i
  %goes_on.11.43358.i = phi i1 [ true, %B1496.preheader.new.i ], [ %"$phi1546.1.2.5.1.i", %B1546.1.i ]
  %.316133543356.i = phi i64 [ 0, %B1496.preheader.new.i ], [ %.3168.147.i, %B1546.1.i ]
  br i1 %goes_on.11.43358.i, label %B1546.i, label %B1546.1.i

B1546.i:                                          ; preds = %B1496.i
  %sunkaddr284.i = shl i64 %.316133543356.i, 3
  %sunkaddr285.i = getelementptr i8, ptr %w21, i64 %sunkaddr284.i
  %.3239.i = load i64, ptr %sunkaddr285.i, align 8
  %.3255.i = icmp slt i64 %.3239.i, 0
  %.3256.i = select i1 %.3255.i, i64 %w38, i64 0
  %128 = getelementptr i64, ptr %w37, i64 %.3239.i
  %.3270.i = getelementptr i64, ptr %128, i64 %.3256.i
  %.3271.i = load i64, ptr %.3270.i, align 8
  %.3272.i = icmp eq i64 %.3271.i, 0
  br i1 %.3272.i, label %B1502.1.i, label %B1546.1.i

B1502.1.i:                                        ; preds = %B1546.i
  %sunkaddr288.i = getelementptr i8, ptr %sunkaddr285.i, i64 8
  %.3239.1.i = load i64, ptr %sunkaddr288.i, align 8
  %.3255.1.i = icmp slt i64 %.3239.1.i, 0
  %.3256.1.i = select i1 %.3255.1.i, i64 %w38, i64 0
  %129 = getelementptr i64, ptr %w37, i64 %.3239.1.i
  %.3270.1.i = getelementptr i64, ptr %129, i64 %.3256.1.i
  %.3271.1.i = load i64, ptr %.3270.1.i, align 8
  %.3272.1.i = icmp eq i64 %.3271.1.i, 0
  br label %B1546.1.i

B1546.1.i:                                        ; preds = %B1502.1.i, %B1546.i, %B1496.i
  %"$phi1546.1.2.5.1.i" = phi i1 [ %.3272.1.i, %B1502.1.i ], [ false, %B1546.i ], [ false, %B1496.i ]
  %.3168.147.i = add nuw i64 %.316133543356.i, 2
  %niter.ncmp.1.i = icmp eq i64 %unroll_iter.i, %.3168.147.i
  br i1 %niter.ncmp.1.i, label %B1550.endif.loopexit.unr-lcssa.i, label %B1496.i

B1580.loopexit.i:                                 ; preds = %B1712.i, %B1712.prol.loopexit.i, %B1582.endif.i
  %exitcond4388.not.i = icmp eq i64 %.3389.i, %count.2.03906.i
  br i1 %exitcond4388.not.i, label %B1760.loopexit.i, label %B1582.endif.i

B1712.i:                                          ; preds = %B1712.preheader183.i, %B1712.i
  %lsr.iv211.i = phi i64 [ %178, %B1712.preheader183.i ], [ %lsr.iv.next212.i, %B1712.i ]
  %.362433633365.i = phi i64 [ %.362433633365.unr.i, %B1712.preheader183.i ], [ %136, %B1712.i ]
  %.3672.i = icmp slt i64 %.362433633365.i, 0
  %130 = select i1 %.3672.i, i64 %3, i64 0
  %scevgep213.i = getelementptr i8, ptr %w10, i64 %130
  %131 = shl i64 %.362433633365.i, 3
  %scevgep214.i = getelementptr i8, ptr %scevgep213.i, i64 %131
  %.3688.i = load i64, ptr %scevgep214.i, align 8
  %.3701.i = icmp slt i64 %.3688.i, 0
  %.3702.i = select i1 %.3701.i, i64 %w30, i64 0
  %132 = getelementptr i64, ptr %w29, i64 %.3688.i
  %.3716.i = getelementptr i64, ptr %132, i64 %.3702.i
  store i64 -1, ptr %.3716.i, align 8
  %133 = add i64 %.362433633365.i, 1
  %.3672.1.i = icmp slt i64 %133, 0
  %134 = select i1 %.3672.1.i, i64 %3, i64 0
  %scevgep215.i = getelementptr i8, ptr %w10, i64 %134
  %scevgep216.i = getelementptr i8, ptr %scevgep215.i, i64 %131
  %scevgep217.i = getelementptr i8, ptr %scevgep216.i, i64 8
  %.3688.1.i = load i64, ptr %scevgep217.i, align 8
  %.3701.1.i = icmp slt i64 %.3688.1.i, 0
  %.3702.1.i = select i1 %.3701.1.i, i64 %w30, i64 0
  %135 = getelementptr i64, ptr %w29, i64 %.3688.1.i
  %.3716.1.i = getelementptr i64, ptr %135, i64 %.3702.1.i
  store i64 -1, ptr %.3716.1.i, align 8
  %lsr.iv.next212.i = add i64 %lsr.iv211.i, -2
  %.3618.1.i = icmp samesign ugt i64 %lsr.iv.next212.i, 2
  %136 = add i64 %.362433633365.i, 2
  br i1 %.3618.1.i, label %B1712.i, label %B1580.loopexit.i

B1760.loopexit.i:                                 ; preds = %B1580.loopexit.i
  %.3757.i = load double, ptr %.533.i, align 8
  %.3759.i = fcmp ogt double %.3757.i, %w36
  %.3762.i = fmul double %last.2.2.i, 1.500000e+00
  %.3764.i = fcmp ogt double %level.2.2.i, %.3762.i
  %or.cond3156.i = select i1 %.3759.i, i1 true, i1 %.3764.i
  br i1 %or.cond3156.i, label %B2492.endif.i, label %B1820.i

B1820.i:                                          ; preds = %B1760.loopexit.i
  br i1 %goes_on.10.3.i, label %B1826.i, label %B2492.endif.i

B1826.i:                                          ; preds = %B1820.i
  %.3829.i = icmp sgt i64 %num.2.3.i, -1
  br i1 %.3829.i, label %B1840.i, label %B2584.i

B1840.i:                                          ; preds = %B1826.i
  %.3879.i = load double, ptr %sunkaddr373.i, align 8
  %.3881.i = fcmp ogt double %.3879.i, 0.000000e+00
  br i1 %.3881.i, label %B1866.i, label %B2492.endif.i

B1866.i:                                          ; preds = %B1840.i
  %.4021.i = load double, ptr %sunkaddr377.i, align 8
  %.4234.i = icmp slt i64 %rows.2.2.i, 0
  %.4235.i = select i1 %.4234.i, i64 %w40, i64 0
  %.4236.i = add i64 %.4235.i, %rows.2.2.i
  %.4256.i = mul i64 %.4236.i, %w41
  %137 = getelementptr double, ptr %w39, i64 %.4256.i
  %.4175.i = load double, ptr %sunkaddr385.i, align 8
  %.4209.i = fdiv double %.4175.i, %.3879.i
  %138 = getelementptr i8, ptr %137, i64 24
  store double %.4209.i, ptr %138, align 8
  %.4344.i = load double, ptr %sunkaddr374.i, align 8
  %.4345.i = fmul double %.4209.i, %.4344.i
  %.4350.i = fdiv double %.4345.i, 3.000000e+00
  %.4352.i = fsub double %.4021.i, %.4350.i
  %.4175.1.i = load double, ptr %sunkaddr389.i, align 8
  %.4205.1.i = load double, ptr %sunkaddr373.i, align 8
  %.4209.1.i = fdiv double %.4175.1.i, %.4205.1.i
  %139 = getelementptr i8, ptr %137, i64 8
  %140 = getelementptr i8, ptr %137, i64 32
  store double %.4209.1.i, ptr %140, align 8
  %.4344.1.i = load double, ptr %sunkaddr375.i, align 8
  %.4345.1.i = fmul double %.4209.1.i, %.4344.1.i
  %.4350.1.i = fdiv double %.4345.1.i, 3.000000e+00
  %.4352.1.i = fsub double %.4352.i, %.4350.1.i
  %.4175.2.i = load double, ptr %sunkaddr393.i, align 8
  %.4205.2.i = load double, ptr %sunkaddr373.i, align 8
  %.4209.2.i = fdiv double %.4175.2.i, %.4205.2.i
  %141 = getelementptr i8, ptr %137, i64 16
  %142 = getelementptr i8, ptr %137, i64 40
  store double %.4209.2.i, ptr %142, align 8
  %.4344.2.i = load double, ptr %sunkaddr376.i, align 8
  %.4345.2.i = fmul double %.4209.2.i, %.4344.2.i
  %.4350.2.i = fdiv double %.4345.2.i, 3.000000e+00
  %.4352.2.i = fsub double %.4352.1.i, %.4350.2.i
  %.3925.i = fmul double %.3757.i, 0x401921FB54442D18
  %.3986.i = fmul double %.3879.i, %.3879.i
  %.3990.i = fdiv double %.3925.i, %.3986.i
  %.3991.i = fadd double %.3990.i, -5.000000e-01
  %.4362.i = fcmp ogt double %.4352.2.i, 0.000000e+00
  %"$phi2134.0.2.4.i" = select i1 %.4362.i, double %.3991.i, double 0.000000e+00
  %.4411.i = load double, ptr %.533.i, align 8
  %.4413.i = fcmp oge double %.4411.i, %w35
  %.4423.i = fmul double %"$phi2134.0.2.4.i", 5.000000e-01
  %"$phi2182.0.2.4.i" = select i1 %.4413.i, double %"$phi2134.0.2.4.i", double %.4423.i
  store double %"$phi2182.0.2.4.i", ptr %137, align 8
  %.4526.i = load double, ptr %.533.i, align 8
  store double %level.2.2.i, ptr %139, align 8
  store double %.4526.i, ptr %141, align 8
  %.4692.i = getelementptr i8, ptr %137, i64 48
  store double %.4352.2.i, ptr %.4692.i, align 8
  %.4752.i = fcmp olt double %"$phi2182.0.2.4.i", %w34
  %.4812.i = fcmp ogt double %"$phi2182.0.2.4.i", %slenderest.2.2.i
  br i1 %.4812.i, label %B2368.i, label %B2478.i

B2368.i:                                          ; preds = %B1866.i, %B2368.i
  %lsr.iv234.i = phi i64 [ %lsr.iv.next235.i, %B2368.i ], [ 32, %B1866.i ]
  %.497033923394.i = phi i64 [ %.4977.3.i, %B2368.i ], [ 0, %B1866.i ]
  %sunkaddr306.i = shl i64 %.497033923394.i, 3
  %sunkaddr307.i = getelementptr i8, ptr %w19, i64 %sunkaddr306.i
  %.5032.i = load i64, ptr %sunkaddr307.i, align 8
  %sunkaddr309.i = getelementptr i8, ptr %w42, i64 %sunkaddr306.i
  store i64 %.5032.i, ptr %sunkaddr309.i, align 8
  %sunkaddr312.i = getelementptr i8, ptr %sunkaddr307.i, i64 8
  %.5032.1.i = load i64, ptr %sunkaddr312.i, align 8
  %sunkaddr315.i = getelementptr i8, ptr %sunkaddr309.i, i64 8
  store i64 %.5032.1.i, ptr %sunkaddr315.i, align 8
  %sunkaddr318.i = getelementptr i8, ptr %sunkaddr307.i, i64 16
  %.5032.2.i = load i64, ptr %sunkaddr318.i, align 8
  %sunkaddr321.i = getelementptr i8, ptr %sunkaddr309.i, i64 16
  store i64 %.5032.2.i, ptr %sunkaddr321.i, align 8
  %.4977.3.i = add nuw nsw i64 %.497033923394.i, 4
  %sunkaddr324.i = getelementptr i8, ptr %sunkaddr307.i, i64 24
  %.5032.3.i = load i64, ptr %sunkaddr324.i, align 8
  %sunkaddr327.i = getelementptr i8, ptr %sunkaddr309.i, i64 24
  store i64 %.5032.3.i, ptr %sunkaddr327.i, align 8
  %niter147.ncmp.3.i = icmp eq i64 %unroll_iter146.i, %.4977.3.i
  %lsr.iv.next235.i = add i64 %lsr.iv234.i, 32
  br i1 %niter147.ncmp.3.i, label %B2404.endif.unr-lcssa.i, label %B2368.i

B2436.i:                                          ; preds = %B2436.preheader.new.i, %B2436.i
  %.516033993401.i = phi i64 [ 0, %B2436.preheader.new.i ], [ %.5167.3.i, %B2436.i ]
  %143 = shl i64 %.516033993401.i, 3
  %sunkaddr329.i = getelementptr i8, ptr %w21, i64 %143
  %.5226.i = load i64, ptr %sunkaddr329.i, align 8
  %scevgep257.i = getelementptr i8, ptr %scevgep251.i, i64 %143
  %scevgep258.i = getelementptr i8, ptr %scevgep257.i, i64 -24
  store i64 %.5226.i, ptr %scevgep258.i, align 8
  %sunkaddr332.i = getelementptr i8, ptr %sunkaddr329.i, i64 8
  %.5226.1.i = load i64, ptr %sunkaddr332.i, align 8
  %scevgep256.i = getelementptr i8, ptr %scevgep257.i, i64 -16
  store i64 %.5226.1.i, ptr %scevgep256.i, align 8
  %sunkaddr335.i = getelementptr i8, ptr %sunkaddr329.i, i64 16
  %.5226.2.i = load i64, ptr %sunkaddr335.i, align 8
  %scevgep254.i = getelementptr i8, ptr %scevgep257.i, i64 -8
  store i64 %.5226.2.i, ptr %scevgep254.i, align 8
  %.5167.3.i = add i64 %.516033993401.i, 4
  %sunkaddr336.i = shl i64 %.5167.3.i, 3
  %sunkaddr337.i = getelementptr i8, ptr %w21, i64 %sunkaddr336.i
  %sunkaddr338.i = getelementptr i8, ptr %sunkaddr337.i, i64 -8
  %.5226.3.i = load i64, ptr %sunkaddr338.i, align 8
  store i64 %.5226.3.i, ptr %scevgep257.i, align 8
  %niter153.ncmp.3.i = icmp eq i64 %unroll_iter152.i, %.5167.3.i
  br i1 %niter153.ncmp.3.i, label %B2478.loopexit.unr-lcssa.i, label %B2436.i

B2478.loopexit.unr-lcssa.i:                       ; preds = %B2436.i
  %lcmp.mod150.not.i = icmp eq i64 %xtraiter148.i, 0
  br i1 %lcmp.mod150.not.i, label %B2478.i, label %B2436.epil.preheader.i

B2436.epil.preheader.i:                           ; preds = %B2436.preheader.i, %B2478.loopexit.unr-lcssa.i
  %.516033993401.epil.init.i = phi i64 [ 0, %B2436.preheader.i ], [ %unroll_iter152.i, %B2478.loopexit.unr-lcssa.i ]
  %144 = shl i64 %.516033993401.epil.init.i, 3
  %scevgep260.i = getelementptr i8, ptr %scevgep259.i, i64 %144
  %scevgep262.i = getelementptr i8, ptr %w21, i64 %144
  br label %B2436.epil.i

B2436.epil.i:                                     ; preds = %B2436.epil.i, %B2436.epil.preheader.i
  %epil.iter149.i = phi i64 [ %epil.iter149.next.i, %B2436.epil.i ], [ 0, %B2436.epil.preheader.i ]
  %145 = shl nuw nsw i64 %epil.iter149.i, 3
  %scevgep263.i = getelementptr i8, ptr %scevgep262.i, i64 %145
  %.5226.epil.i = load i64, ptr %scevgep263.i, align 8
  %scevgep261.i = getelementptr i8, ptr %scevgep260.i, i64 %145
  store i64 %.5226.epil.i, ptr %scevgep261.i, align 8
  %epil.iter149.next.i = add i64 %epil.iter149.i, 1
  %epil.iter149.cmp.not.i = icmp eq i64 %xtraiter148.i, %epil.iter149.next.i
  br i1 %epil.iter149.cmp.not.i, label %B2478.i, label %B2436.epil.i

B2478.i:                                          ; preds = %B2436.epil.i, %B2404.endif.i, %B2478.loopexit.unr-lcssa.i, %B1866.i
  %size_of_region.7.4.i = phi i64 [ %size_of_region.4.2.i, %B1866.i ], [ %.4877.i, %B2404.endif.i ], [ %.4877.i, %B2478.loopexit.unr-lcssa.i ], [ %.4877.i, %B2436.epil.i ]
  %slenderest.5.4.i = phi double [ %slenderest.2.2.i, %B1866.i ], [ %"$phi2182.0.2.4.i", %B2404.endif.i ], [ %"$phi2182.0.2.4.i", %B2478.loopexit.unr-lcssa.i ], [ %"$phi2182.0.2.4.i", %B2436.epil.i ]
  %.5284.i = add nsw i64 %rows.2.2.i, 1
  br label %B2492.endif.i

B2524.i:                                          ; preds = %B2524.preheader.new.i, %B2524.i
  %.540634063408.i = phi i64 [ 0, %B2524.preheader.new.i ], [ %.5413.3.i, %B2524.i ]
  %sunkaddr339.i = shl i64 %.540634063408.i, 3
  %sunkaddr340.i = getelementptr i8, ptr %w21, i64 %sunkaddr339.i
  %.5480.i = load i64, ptr %sunkaddr340.i, align 8
  %.5493.i = icmp slt i64 %.5480.i, 0
  %.5494.i = select i1 %.5493.i, i64 %w18, i64 0
  %146 = getelementptr i64, ptr %w17, i64 %.5480.i
  %.5508.i = getelementptr i64, ptr %146, i64 %.5494.i
  store i64 0, ptr %.5508.i, align 8
  %sunkaddr343.i = getelementptr i8, ptr %sunkaddr340.i, i64 8
  %.5480.1.i = load i64, ptr %sunkaddr343.i, align 8
  %.5493.1.i = icmp slt i64 %.5480.1.i, 0
  %.5494.1.i = select i1 %.5493.1.i, i64 %w18, i64 0
  %147 = getelementptr i64, ptr %w17, i64 %.5480.1.i
  %.5508.1.i = getelementptr i64, ptr %147, i64 %.5494.1.i
  store i64 0, ptr %.5508.1.i, align 8
  %sunkaddr346.i = getelementptr i8, ptr %sunkaddr340.i, i64 16
  %.5480.2.i = load i64, ptr %sunkaddr346.i, align 8
  %.5493.2.i = icmp slt i64 %.5480.2.i, 0
  %.5494.2.i = select i1 %.5493.2.i, i64 %w18, i64 0
  %148 = getelementptr i64, ptr %w17, i64 %.5480.2.i
  %.5508.2.i = getelementptr i64, ptr %148, i64 %.5494.2.i
  store i64 0, ptr %.5508.2.i, align 8
  %.5413.3.i = add nuw nsw i64 %.540634063408.i, 4
  %sunkaddr349.i = getelementptr i8, ptr %sunkaddr340.i, i64 24
  %.5480.3.i = load i64, ptr %sunkaddr349.i, align 8
  %.5493.3.i = icmp slt i64 %.5480.3.i, 0
  %.5494.3.i = select i1 %.5493.3.i, i64 %w18, i64 0
  %149 = getelementptr i64, ptr %w17, i64 %.5480.3.i
  %.5508.3.i = getelementptr i64, ptr %149, i64 %.5494.3.i
  store i64 0, ptr %.5508.3.i, align 8
  %niter159.ncmp.3.i = icmp eq i64 %unroll_iter158.i, %.5413.3.i
  br i1 %niter159.ncmp.3.i, label %B2584.loopexit.unr-lcssa.i, label %B2524.i

B2584.loopexit.unr-lcssa.i:                       ; preds = %B2524.i
  %lcmp.mod156.not.i = icmp eq i64 %xtraiter154.i, 0
  br i1 %lcmp.mod156.not.i, label %B2584.i, label %B2524.epil.preheader.i

B2524.epil.preheader.i:                           ; preds = %B2524.preheader.i, %B2584.loopexit.unr-lcssa.i
  %.540634063408.epil.init.i = phi i64 [ 0, %B2524.preheader.i ], [ %unroll_iter158.i, %B2584.loopexit.unr-lcssa.i ]
  %150 = shl i64 %.540634063408.epil.init.i, 3
  %scevgep271.i = getelementptr i8, ptr %w21, i64 %150
  br label %B2524.epil.i

B2524.epil.i:                                     ; preds = %B2524.epil.i, %B2524.epil.preheader.i
  %epil.iter155.i = phi i64 [ %epil.iter155.next.i, %B2524.epil.i ], [ 0, %B2524.epil.preheader.i ]
  %151 = shl nuw nsw i64 %epil.iter155.i, 3
  %scevgep272.i = getelementptr i8, ptr %scevgep271.i, i64 %151
  %.5480.epil.i = load i64, ptr %scevgep272.i, align 8
  %.5493.epil.i = icmp slt i64 %.5480.epil.i, 0
  %.5494.epil.i = select i1 %.5493.epil.i, i64 %w18, i64 0
  %152 = getelementptr i64, ptr %w17, i64 %.5480.epil.i
  %.5508.epil.i = getelementptr i64, ptr %152, i64 %.5494.epil.i
  store i64 0, ptr %.5508.epil.i, align 8
  %epil.iter155.next.i = add i64 %epil.iter155.i, 1
  %epil.iter155.cmp.not.i = icmp eq i64 %xtraiter154.i, %epil.iter155.next.i
  br i1 %epil.iter155.cmp.not.i, label %B2584.i, label %B2524.epil.i

B2584.i:                                          ; preds = %B2524.epil.i, %B2492.endif.i, %B2584.loopexit.unr-lcssa.i, %B1826.i, %B570.i
  %rows.3.3.i = phi i64 [ %rows.2.2.i, %B570.i ], [ %rows.4.3.i, %B2492.endif.i ], [ %rows.2.2.i, %B1826.i ], [ %rows.4.3.i, %B2584.loopexit.unr-lcssa.i ], [ %rows.4.3.i, %B2524.epil.i ]
  %size_of_region.5.3.i = phi i64 [ %size_of_region.4.2.i, %B570.i ], [ %size_of_region.6.3.i, %B2492.endif.i ], [ %size_of_region.4.2.i, %B1826.i ], [ %size_of_region.6.3.i, %B2584.loopexit.unr-lcssa.i ], [ %size_of_region.6.3.i, %B2524.epil.i ]
  %last.3.3.i = phi double [ %last.2.2.i, %B570.i ], [ %last.4.3.i, %B2492.endif.i ], [ %last.2.2.i, %B1826.i ], [ %last.4.3.i, %B2584.loopexit.unr-lcssa.i ], [ %last.4.3.i, %B2524.epil.i ]
  %slenderest.3.3.i = phi double [ %slenderest.2.2.i, %B570.i ], [ %slenderest.4.3.i, %B2492.endif.i ], [ %slenderest.2.2.i, %B1826.i ], [ %slenderest.4.3.i, %B2584.loopexit.unr-lcssa.i ], [ %slenderest.4.3.i, %B2524.epil.i ]
  %goes_on.8.3.i = phi i1 [ true, %B570.i ], [ %goes_on.9.3.i, %B2492.endif.i ], [ true, %B1826.i ], [ %goes_on.9.3.i, %B2584.loopexit.unr-lcssa.i ], [ %goes_on.9.3.i, %B2524.epil.i ]
  %.5543.i = fmul double %w33, %level.2.2.i
  br i1 %goes_on.8.3.i, label %B316.i, label %B2590.i

B2590.i:                                          ; preds = %B568.i, %B2584.i
  %rows.6.1.i = phi i64 [ %rows.3.3.i, %B2584.i ], [ %.us-phi3605.i, %B568.i ]
  %size_of_region.2.1.i = phi i64 [ %size_of_region.5.3.i, %B2584.i ], [ %.us-phi3606.i, %B568.i ]
  %.5670.i = icmp slt i64 %size_of_region.2.1.i, %w43
  br i1 %.5670.i, label %B2628.i, label %B2638.endif.i

B2628.i:                                          ; preds = %B2590.i
  %153 = getelementptr i64, ptr %w42, i64 %size_of_region.2.1.i
  store i64 -1, ptr %153, align 8
  br label %B2638.endif.i

B2706.i:                                          ; preds = %B2706.preheader.new.i, %B2706.i
  %.580839423944.i = phi i64 [ 0, %B2706.preheader.new.i ], [ %.5815.3.i, %B2706.i ]
  %sunkaddr350.i = shl i64 %.580839423944.i, 3
  %sunkaddr351.i = getelementptr i8, ptr %w15, i64 %sunkaddr350.i
  store double 0x7FF0000000000000, ptr %sunkaddr351.i, align 8
  %sunkaddr353.i = getelementptr i8, ptr %w17, i64 %sunkaddr350.i
  store i64 0, ptr %sunkaddr353.i, align 8
  %sunkaddr356.i = getelementptr i8, ptr %sunkaddr351.i, i64 8
  store double 0x7FF0000000000000, ptr %sunkaddr356.i, align 8
  %sunkaddr359.i = getelementptr i8, ptr %sunkaddr353.i, i64 8
  store i64 0, ptr %sunkaddr359.i, align 8
  %sunkaddr362.i = getelementptr i8, ptr %sunkaddr351.i, i64 16
  store double 0x7FF0000000000000, ptr %sunkaddr362.i, align 8
  %sunkaddr365.i = getelementptr i8, ptr %sunkaddr353.i, i64 16
  store i64 0, ptr %sunkaddr365.i, align 8
  %.5815.3.i = add nuw nsw i64 %.580839423944.i, 4
  %sunkaddr368.i = getelementptr i8, ptr %sunkaddr351.i, i64 24
  store double 0x7FF0000000000000, ptr %sunkaddr368.i, align 8
  %sunkaddr371.i = getelementptr i8, ptr %sunkaddr353.i, i64 24
  store i64 0, ptr %sunkaddr371.i, align 8
  %niter165.ncmp.3.i = icmp eq i64 %unroll_iter164.i, %.5815.3.i
  br i1 %niter165.ncmp.3.i, label %B2762.loopexit.unr-lcssa.i, label %B2706.i

B2762.loopexit.unr-lcssa.i:                       ; preds = %B2706.i
  %lcmp.mod162.not.i = icmp eq i64 %xtraiter160.i, 0
  br i1 %lcmp.mod162.not.i, label %_ZN7msf_jax4host4thin6fronts3capB3v41B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xddddd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B2706.epil.preheader.i

B2706.epil.preheader.i:                           ; preds = %B2706.preheader.i, %B2762.loopexit.unr-lcssa.i
  %.580839423944.epil.init.i = phi i64 [ 0, %B2706.preheader.i ], [ %unroll_iter164.i, %B2762.loopexit.unr-lcssa.i ]
  %154 = shl i64 %.580839423944.epil.init.i, 3
  %scevgep.i = getelementptr i8, ptr %w17, i64 %154
  %scevgep187.i = getelementptr i8, ptr %w15, i64 %154
  br label %B2706.epil.i

B2706.epil.i:                                     ; preds = %B2706.epil.i, %B2706.epil.preheader.i
  %epil.iter161.i = phi i64 [ %epil.iter161.next.i, %B2706.epil.i ], [ 0, %B2706.epil.preheader.i ]
  %155 = shl nuw nsw i64 %epil.iter161.i, 3
  %scevgep188.i = getelementptr i8, ptr %scevgep187.i, i64 %155
  store double 0x7FF0000000000000, ptr %scevgep188.i, align 8
  %scevgep186.i = getelementptr i8, ptr %scevgep.i, i64 %155
  store i64 0, ptr %scevgep186.i, align 8
  %epil.iter161.next.i = add i64 %epil.iter161.i, 1
  %epil.iter161.cmp.not.i = icmp eq i64 %xtraiter160.i, %epil.iter161.next.i
  br i1 %epil.iter161.cmp.not.i, label %_ZN7msf_jax4host4thin6fronts3capB3v41B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xddddd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B2706.epil.i

B2763.i:                                          ; preds = %B1234.lr.ph.i, %B976.endif.lr.ph.i, %B1046.i
  %rings.3.5.i = phi i64 [ %rings.2.43283.i, %B1046.i ], [ %.2688.i, %B1234.lr.ph.i ], [ %rings.2.43283.i, %B976.endif.lr.ph.i ]
  %longest.4.5.i = phi i64 [ %longest.3.43284.i, %B1046.i ], [ %longest.6.8.i, %B1234.lr.ph.i ], [ %longest.3.43284.i, %B976.endif.lr.ph.i ]
  %lsr.iv.next.i = add i64 %lsr.iv.i, -1
  %.1742.i = add i64 %.173532403281.i, 1
  %.1729.i = icmp samesign ugt i64 %lsr.iv.next.i, 1
  br i1 %.1729.i, label %B870.i, label %B738.loopexit.i

B380.endif.i:                                     ; preds = %B236.i.i, %B200.i.i, %B380.i
  %at.3.1.i.i = phi i64 [ 0, %B380.i ], [ %child.2.1.i.i, %B236.i.i ], [ %at.2.0.i.i, %B200.i.i ]
  %.469.i.i = icmp slt i64 %at.3.1.i.i, 0
  %.470.i.i = select i1 %.469.i.i, i64 %w26, i64 0
  %156 = getelementptr double, ptr %w25, i64 %at.3.1.i.i
  %.484.i.i = getelementptr double, ptr %156, i64 %.470.i.i
  store double %.114.i.i, ptr %.484.i.i, align 8
  %.507.i.i = select i1 %.469.i.i, i64 %w28, i64 0
  %157 = getelementptr i64, ptr %w27, i64 %at.3.1.i.i
  %.521.i.i = getelementptr i64, ptr %157, i64 %.507.i.i
  store i64 %.146.i.i, ptr %.521.i.i, align 8
  %.859.i = icmp slt i64 %.us-phi3609.i, 0
  %.860.i = select i1 %.859.i, i64 %w18, i64 0
  %158 = getelementptr i64, ptr %w17, i64 %.us-phi3609.i
  %.874.i = getelementptr i64, ptr %158, i64 %.860.i
  %.875.i = load i64, ptr %.874.i, align 8
  %.876.not.i = icmp eq i64 %.875.i, 1
  br i1 %.876.not.i, label %B568.i, label %B446.i

B740.endif.preheader.i:                           ; preds = %B570.i
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(40) %.533.i, i8 0, i64 40, i1 false)
  store double 0.000000e+00, ptr %sunkaddr373.i, align 8
  br label %B740.endif.i

B740.endif.i:                                     ; preds = %B740.endif.preheader.i, %B738.loopexit.i
  %longest.2.33333.i = phi i64 [ %longest.3.4.lcssa.i, %B738.loopexit.i ], [ 0, %B740.endif.preheader.i ]
  %rings.5.33332.i = phi i64 [ %rings.2.4.lcssa.i, %B738.loopexit.i ], [ 0, %B740.endif.preheader.i ]
  %.148132973330.i = phi i64 [ %.1488.i, %B738.loopexit.i ], [ 0, %B740.endif.preheader.i ]
  %.1488.i = add nuw nsw i64 %.148132973330.i, 1
  %159 = getelementptr i64, ptr %w19, i64 %.148132973330.i
  %.1557.i = load i64, ptr %159, align 8
  %.1570.i = icmp slt i64 %.1557.i, 0
  %.1571.i = select i1 %.1570.i, i64 %w9, i64 0
  %160 = getelementptr i64, ptr %w8, i64 %.1557.i
  %.1585.i = getelementptr i64, ptr %160, i64 %.1571.i
  %.1586.i = load i64, ptr %.1585.i, align 8
  %.1633.i = icmp slt i64 %.1557.i, -1
  %.1634.i = select i1 %.1633.i, i64 %w9, i64 0
  %161 = getelementptr i8, ptr %160, i64 8
  %.1648.i = getelementptr i64, ptr %161, i64 %.1634.i
  %.1649.i = load i64, ptr %.1648.i, align 8
  %.1686.i = sub i64 %.1649.i, %.1586.i
  %.17293274.not.i = icmp slt i64 %.1686.i, 1
  br i1 %.17293274.not.i, label %B738.loopexit.i, label %B870.preheader.i

B870.preheader.i:                                 ; preds = %B740.endif.i
  %162 = add nuw i64 %.1686.i, 1
  br label %B870.i

B976.endif.lr.ph.i:                               ; preds = %B140.endif.i.i
  %.2037.i = select i1 %.304.i.i, i64 %w13, i64 0
  %.2038.i = add i64 %.2037.i, %.1797.i
  %.2058.i = mul i64 %.2038.i, %w14
  %163 = getelementptr double, ptr %w12, i64 %.2058.i
  %.2011.i = load double, ptr %.533.i, align 8
  %.2063.i = load double, ptr %163, align 8
  %.2068.i = fdiv double %.2063.i, 3.000000e+00
  %.2069.i = fadd double %.2011.i, %.2068.i
  store double %.2069.i, ptr %.533.i, align 8
  %.2011.1.i = load double, ptr %sunkaddr374.i, align 8
  %164 = getelementptr i8, ptr %163, i64 8
  %.2063.1.i = load double, ptr %164, align 8
  %.2068.1.i = fdiv double %.2063.1.i, 3.000000e+00
  %.2069.1.i = fadd double %.2011.1.i, %.2068.1.i
  store double %.2069.1.i, ptr %sunkaddr374.i, align 8
  %.2011.2.i = load double, ptr %sunkaddr375.i, align 8
  %165 = getelementptr i8, ptr %163, i64 16
  %.2063.2.i = load double, ptr %165, align 8
  %.2068.2.i = fdiv double %.2063.2.i, 3.000000e+00
  %.2069.2.i = fadd double %.2011.2.i, %.2068.2.i
  store double %.2069.2.i, ptr %sunkaddr375.i, align 8
  %.2011.3.i = load double, ptr %sunkaddr376.i, align 8
  %166 = getelementptr i8, ptr %163, i64 24
  %.2063.3.i = load double, ptr %166, align 8
  %.2068.3.i = fdiv double %.2063.3.i, 3.000000e+00
  %.2069.3.i = fadd double %.2011.3.i, %.2068.3.i
  store double %.2069.3.i, ptr %sunkaddr376.i, align 8
  %.2011.4.i = load double, ptr %sunkaddr377.i, align 8
  %167 = getelementptr i8, ptr %163, i64 32
  %.2063.4.i = load double, ptr %167, align 8
  %.2068.4.i = fdiv double %.2063.4.i, 3.000000e+00
  %.2069.4.i = fadd double %.2011.4.i, %.2068.4.i
  store double %.2069.4.i, ptr %sunkaddr377.i, align 8
  br label %B2763.i

B1176.preheader.i:                                ; preds = %_ZN7msf_jax4host4thin6fronts12ring_throughB3v45B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx5ArrayIdLi1E1C7mutable7alignedE.exit.i
  store double %.2430.i, ptr %sunkaddr373.i, align 8
  %.2430.1.i = load double, ptr %sunkaddr1.i.i, align 8
  store double %.2430.1.i, ptr %sunkaddr385.i, align 8
  %.2430.2.i = load double, ptr %sunkaddr.i36.i, align 8
  store double %.2430.2.i, ptr %sunkaddr389.i, align 8
  %.2430.3.i = load double, ptr %sunkaddr2.i.i, align 8
  store double %.2430.3.i, ptr %sunkaddr393.i, align 8
  %.2645.pre.i = load double, ptr %sunkaddr3.i.i, align 8
  br label %B1234.lr.ph.i

B1234.lr.ph.i:                                    ; preds = %B1176.preheader.i, %_ZN7msf_jax4host4thin6fronts12ring_throughB3v45B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.2645.i = phi double [ %.264578.i, %_ZN7msf_jax4host4thin6fronts12ring_throughB3v45B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.2645.pre.i, %B1176.preheader.i ]
  %longest.6.8.i = phi i64 [ %longest.3.43284.i, %_ZN7msf_jax4host4thin6fronts12ring_throughB3v45B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xdx5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %rings.2.43283.i, %B1176.preheader.i ]
  %.2614.i = load double, ptr %.533.i, align 8
  %.2646.i = fadd double %.2645.i, %.2614.i
  store double %.2646.i, ptr %.533.i, align 8
  %.2614.1.i = load double, ptr %sunkaddr374.i, align 8
  %.2645.1.i = load double, ptr %sunkaddr4.i.i, align 8
  %.2646.1.i = fadd double %.2614.1.i, %.2645.1.i
  store double %.2646.1.i, ptr %sunkaddr374.i, align 8
  %.2614.2.i = load double, ptr %sunkaddr375.i, align 8
  %.2645.2.i = load double, ptr %sunkaddr5.i.i, align 8
  %.2646.2.i = fadd double %.2614.2.i, %.2645.2.i
  store double %.2646.2.i, ptr %sunkaddr375.i, align 8
  %.2614.3.i = load double, ptr %sunkaddr376.i, align 8
  %.2645.3.i = load double, ptr %sunkaddr6.i.i, align 8
  %.2646.3.i = fadd double %.2614.3.i, %.2645.3.i
  store double %.2646.3.i, ptr %sunkaddr376.i, align 8
  %.2614.4.i = load double, ptr %sunkaddr377.i, align 8
  %.2645.4.i = load double, ptr %sunkaddr7.i.i, align 8
  %.2646.4.i = fadd double %.2614.4.i, %.2645.4.i
  store double %.2646.4.i, ptr %sunkaddr377.i, align 8
  %.2688.i = add nsw i64 %rings.2.43283.i, 1
  br label %B2763.i

B1496.preheader.i:                                ; preds = %_ZN7msf_jax4host4thin6fronts7islandsB3v47B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xxd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.2996.i = load double, ptr %.533.i, align 8
  %.3026.i = load double, ptr %.451.i, align 8
  %.3027.i = fadd double %.2996.i, %.3026.i
  store double %.3027.i, ptr %.533.i, align 8
  %.2996.1.i = load double, ptr %sunkaddr374.i, align 8
  %.3026.1.i = load double, ptr %sunkaddr83.i.i, align 8
  %.3027.1.i = fadd double %.2996.1.i, %.3026.1.i
  store double %.3027.1.i, ptr %sunkaddr374.i, align 8
  %.2996.2.i = load double, ptr %sunkaddr375.i, align 8
  %.3026.2.i = load double, ptr %sunkaddr84.i.i, align 8
  %.3027.2.i = fadd double %.2996.2.i, %.3026.2.i
  store double %.3027.2.i, ptr %sunkaddr375.i, align 8
  %.2996.3.i = load double, ptr %sunkaddr376.i, align 8
  %.3026.3.i = load double, ptr %sunkaddr85.i.i, align 8
  %.3027.3.i = fadd double %.2996.3.i, %.3026.3.i
  store double %.3027.3.i, ptr %sunkaddr376.i, align 8
  %.2996.4.i = load double, ptr %sunkaddr377.i, align 8
  %.3026.4.i = load double, ptr %sunkaddr86.i.i, align 8
  %.3027.4.i = fadd double %.2996.4.i, %.3026.4.i
  store double %.3027.4.i, ptr %sunkaddr377.i, align 8
  %168 = icmp eq i64 %num.4.1.lcssa.i.i, 1
  br i1 %168, label %B1502.epil.i, label %B1496.preheader.new.i

B1496.preheader.new.i:                            ; preds = %B1496.preheader.i
  %unroll_iter.i = and i64 %num.4.1.lcssa.i.i, 9223372036854775806
  br label %B1496.i

B1550.endif.loopexit.unr-lcssa.i:                 ; preds = %B1546.1.i
  %169 = and i64 %num.4.1.lcssa.i.i, 1
  %lcmp.mod.not.i = icmp eq i64 %169, 0
  %"$phi1546.1.2.5.1.not.i" = xor i1 %"$phi1546.1.2.5.1.i", true
  %brmerge.i = select i1 %lcmp.mod.not.i, i1 true, i1 %"$phi1546.1.2.5.1.not.i"
  %"$phi1546.1.2.5.1.mux.i" = select i1 %lcmp.mod.not.i, i1 %"$phi1546.1.2.5.1.i", i1 false
  br i1 %brmerge.i, label %B1550.endif.i, label %B1502.epil.i

B1502.epil.i:                                     ; preds = %B1550.endif.loopexit.unr-lcssa.i, %B1496.preheader.i
  %.316133543356.epil.init50.i = phi i64 [ %unroll_iter.i, %B1550.endif.loopexit.unr-lcssa.i ], [ 0, %B1496.preheader.i ]
  %170 = getelementptr i64, ptr %w21, i64 %.316133543356.epil.init50.i
  %.3239.epil.i = load i64, ptr %170, align 8
  %.3255.epil.i = icmp slt i64 %.3239.epil.i, 0
  %.3256.epil.i = select i1 %.3255.epil.i, i64 %w38, i64 0
  %171 = getelementptr i64, ptr %w37, i64 %.3239.epil.i
  %.3270.epil.i = getelementptr i64, ptr %171, i64 %.3256.epil.i
  %.3271.epil.i = load i64, ptr %.3270.epil.i, align 8
  %.3272.epil.i = icmp eq i64 %.3271.epil.i, 0
  br label %B1550.endif.i

B1550.endif.i:                                    ; preds = %B878.epil.i.i, %B1502.epil.i, %B1550.endif.loopexit.unr-lcssa.i, %_ZN7msf_jax4host4thin6fronts7islandsB3v47B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xxd5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B846.endif.split.us.i.i, %common.ret.loopexit.unr-lcssa.i.i, %B1304.i
  %goes_on.10.3.i = phi i1 [ true, %B1304.i ], [ %"$phi1546.1.2.5.1.mux.i", %B1550.endif.loopexit.unr-lcssa.i ], [ true, %_ZN7msf_jax4host4thin6fronts7islandsB3v47B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xxd5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.3272.epil.i, %B1502.epil.i ], [ true, %common.ret.loopexit.unr-lcssa.i.i ], [ true, %B846.endif.split.us.i.i ], [ true, %B878.epil.i.i ]
  %num.2.3.i = phi i64 [ 0, %B1304.i ], [ %num.4.1.lcssa.i.i, %B1550.endif.loopexit.unr-lcssa.i ], [ %num.4.1.lcssa.i.i, %_ZN7msf_jax4host4thin6fronts7islandsB3v47B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xxd5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %num.4.1.lcssa.i.i, %B1502.epil.i ], [ -1, %common.ret.loopexit.unr-lcssa.i.i ], [ -1, %B846.endif.split.us.i.i ], [ -1, %B878.epil.i.i ]
  br label %B1582.endif.i

B1582.endif.i:                                    ; preds = %B1550.endif.i, %B1580.loopexit.i
  %.338233703376.i = phi i64 [ %.3389.i, %B1580.loopexit.i ], [ 0, %B1550.endif.i ]
  %.3389.i = add nuw nsw i64 %.338233703376.i, 1
  %172 = getelementptr i64, ptr %w19, i64 %.338233703376.i
  %.3446.i = load i64, ptr %172, align 8
  %.3459.i = icmp slt i64 %.3446.i, 0
  %.3460.i = select i1 %.3459.i, i64 %w9, i64 0
  %173 = getelementptr i64, ptr %w8, i64 %.3446.i
  %.3474.i = getelementptr i64, ptr %173, i64 %.3460.i
  %.3475.i = load i64, ptr %.3474.i, align 8
  %.3522.i = icmp slt i64 %.3446.i, -1
  %.3523.i = select i1 %.3522.i, i64 %w9, i64 0
  %174 = getelementptr i8, ptr %173, i64 8
  %.3537.i = getelementptr i64, ptr %174, i64 %.3523.i
  %.3538.i = load i64, ptr %.3537.i, align 8
  %.3575.i = sub i64 %.3538.i, %.3475.i
  %.36183364.not.i = icmp slt i64 %.3575.i, 1
  br i1 %.36183364.not.i, label %B1580.loopexit.i, label %B1712.preheader.i

B1712.preheader.i:                                ; preds = %B1582.endif.i
  %.neg.i = add i64 %.3475.i, 1
  %xtraiter141.i = and i64 %.3575.i, 1
  %lcmp.mod142.not.i = icmp eq i64 %xtraiter141.i, 0
  br i1 %lcmp.mod142.not.i, label %B1712.prol.loopexit.i, label %B1712.prol.i

B1712.prol.i:                                     ; preds = %B1712.preheader.i
  %.3627.prol.i = add nsw i64 %.3575.i, -1
  %.3672.prol.i = icmp slt i64 %.3475.i, 0
  %.3673.prol.i = select i1 %.3672.prol.i, i64 %w11, i64 0
  %175 = getelementptr i64, ptr %w10, i64 %.3475.i
  %.3687.prol.i = getelementptr i64, ptr %175, i64 %.3673.prol.i
  %.3688.prol.i = load i64, ptr %.3687.prol.i, align 8
  %.3701.prol.i = icmp slt i64 %.3688.prol.i, 0
  %.3702.prol.i = select i1 %.3701.prol.i, i64 %w30, i64 0
  %176 = getelementptr i64, ptr %w29, i64 %.3688.prol.i
  %.3716.prol.i = getelementptr i64, ptr %176, i64 %.3702.prol.i
  store i64 -1, ptr %.3716.prol.i, align 8
  br label %B1712.prol.loopexit.i

B1712.prol.loopexit.i:                            ; preds = %B1712.prol.i, %B1712.preheader.i
  %.361733623366.unr.i = phi i64 [ %.3575.i, %B1712.preheader.i ], [ %.3627.prol.i, %B1712.prol.i ]
  %.362433633365.unr.i = phi i64 [ %.3475.i, %B1712.preheader.i ], [ %.neg.i, %B1712.prol.i ]
  %177 = icmp eq i64 %.3538.i, %.neg.i
  br i1 %177, label %B1580.loopexit.i, label %B1712.preheader183.i

B1712.preheader183.i:                             ; preds = %B1712.prol.loopexit.i
  %178 = add nuw i64 %.361733623366.unr.i, 2
  br label %B1712.i

B2404.endif.unr-lcssa.i:                          ; preds = %B2368.i
  br i1 %5, label %B2404.endif.i, label %B2368.epil.i

B2368.epil.i:                                     ; preds = %B2404.endif.unr-lcssa.i, %B2368.epil.i
  %lsr.iv240.i = phi i64 [ %lsr.iv.next241.i, %B2368.epil.i ], [ %xtraiter143.i, %B2404.endif.unr-lcssa.i ]
  %lsr.iv236.i = phi i64 [ %lsr.iv.next237.i, %B2368.epil.i ], [ %lsr.iv234.i, %B2404.endif.unr-lcssa.i ]
  %scevgep239.i = getelementptr i8, ptr %w19, i64 %lsr.iv236.i
  %.5032.epil.i = load i64, ptr %scevgep239.i, align 8
  %scevgep238.i = getelementptr i8, ptr %w42, i64 %lsr.iv236.i
  store i64 %.5032.epil.i, ptr %scevgep238.i, align 8
  %lsr.iv.next237.i = add nuw nsw i64 %lsr.iv236.i, 8
  %lsr.iv.next241.i = add nsw i64 %lsr.iv240.i, -1
  %epil.iter.cmp.not.i = icmp eq i64 %lsr.iv.next241.i, 0
  br i1 %epil.iter.cmp.not.i, label %B2404.endif.i, label %B2368.epil.i

B2404.endif.i:                                    ; preds = %B2368.epil.i, %B2404.endif.unr-lcssa.i
  %.4877.i = add nuw nsw i64 %num.2.3.i, %count.2.03906.i
  %.51543400.not.i = icmp eq i64 %num.2.3.i, 0
  br i1 %.51543400.not.i, label %B2478.i, label %B2436.preheader.i

B2436.preheader.i:                                ; preds = %B2404.endif.i
  %xtraiter148.i = and i64 %num.2.3.i, 3
  %179 = icmp samesign ult i64 %num.2.3.i, 4
  br i1 %179, label %B2436.epil.preheader.i, label %B2436.preheader.new.i

B2436.preheader.new.i:                            ; preds = %B2436.preheader.i
  %unroll_iter152.i = and i64 %num.2.3.i, 9223372036854775804
  br label %B2436.i

B2492.endif.i:                                    ; preds = %B2478.i, %B1840.i, %B1820.i, %B1760.loopexit.i
  %rows.4.3.i = phi i64 [ %rows.2.2.i, %B1820.i ], [ %.5284.i, %B2478.i ], [ %rows.2.2.i, %B1840.i ], [ %rows.2.2.i, %B1760.loopexit.i ]
  %size_of_region.6.3.i = phi i64 [ %size_of_region.4.2.i, %B1820.i ], [ %size_of_region.7.4.i, %B2478.i ], [ %size_of_region.4.2.i, %B1840.i ], [ %size_of_region.4.2.i, %B1760.loopexit.i ]
  %last.4.3.i = phi double [ %last.2.2.i, %B1820.i ], [ %level.2.2.i, %B2478.i ], [ %last.2.2.i, %B1840.i ], [ %last.2.2.i, %B1760.loopexit.i ]
  %slenderest.4.3.i = phi double [ %slenderest.2.2.i, %B1820.i ], [ %slenderest.5.4.i, %B2478.i ], [ %slenderest.2.2.i, %B1840.i ], [ %slenderest.2.2.i, %B1760.loopexit.i ]
  %goes_on.9.3.i = phi i1 [ false, %B1820.i ], [ %.4752.i, %B2478.i ], [ true, %B1840.i ], [ false, %B1760.loopexit.i ]
  %.54003407.not.i = icmp slt i64 %num.2.3.i, 1
  br i1 %.54003407.not.i, label %B2584.i, label %B2524.preheader.i

B2524.preheader.i:                                ; preds = %B2492.endif.i
  %xtraiter154.i = and i64 %num.2.3.i, 3
  %180 = icmp samesign ult i64 %num.2.3.i, 4
  br i1 %180, label %B2524.epil.preheader.i, label %B2524.preheader.new.i

B2524.preheader.new.i:                            ; preds = %B2524.preheader.i
  %unroll_iter158.i = and i64 %num.2.3.i, 9223372036854775804
  br label %B2524.i

B2638.endif.i:                                    ; preds = %B2628.i, %B2590.i
  %.58023943.not.i = icmp slt i64 %w16, 1
  br i1 %.58023943.not.i, label %_ZN7msf_jax4host4thin6fronts3capB3v41B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xddddd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B2706.preheader.i

B2706.preheader.i:                                ; preds = %B2638.endif.i
  %xtraiter160.i = and i64 %w16, 3
  %181 = icmp samesign ult i64 %w16, 4
  br i1 %181, label %B2706.epil.preheader.i, label %B2706.preheader.new.i

B2706.preheader.new.i:                            ; preds = %B2706.preheader.i
  %unroll_iter164.i = and i64 %w16, 9223372036854775804
  br label %B2706.i

_ZN7msf_jax4host4thin6fronts3capB3v41B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE233Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_29307Scratch_28array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29xddddd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B2706.epil.i, %B2762.loopexit.unr-lcssa.i, %B2638.endif.i
  ret i64 %rows.6.1.i
}

define i64 @msf_jax.host.meso.kernels.short_edges(ptr readonly %words) local_unnamed_addr {
  %w0 = load ptr, ptr %words, align 8
  %p2 = getelementptr i8, ptr %words, i64 16
  %w2 = load i64, ptr %p2, align 8
  %p3 = getelementptr i8, ptr %words, i64 24
  %w3 = load ptr, ptr %p3, align 8
  %p4 = getelementptr i8, ptr %words, i64 32
  %w4 = load i64, ptr %p4, align 8
  %p5 = getelementptr i8, ptr %words, i64 40
  %w5 = load i64, ptr %p5, align 8
  %s8 = shl i64 %w5, 3
  %p6 = getelementptr i8, ptr %words, i64 48
  %w6 = load ptr, ptr %p6, align 8
  %p8 = getelementptr i8, ptr %words, i64 64
  %w8 = load ptr, ptr %p8, align 8
  %p10 = getelementptr i8, ptr %words, i64 80
  %w10 = load double, ptr %p10, align 8
  %p11 = getelementptr i8, ptr %words, i64 88
  %w11 = load ptr, ptr %p11, align 8
  %p12 = getelementptr i8, ptr %words, i64 96
  %w12 = load i64, ptr %p12, align 8
  %p13 = getelementptr i8, ptr %words, i64 104
  %w13 = load i64, ptr %p13, align 8
  %p14 = getelementptr i8, ptr %words, i64 112
  %w14 = load ptr, ptr %p14, align 8
  %p15 = getelementptr i8, ptr %words, i64 120
  %w15 = load i64, ptr %p15, align 8
  %p16 = getelementptr i8, ptr %words, i64 128
  %w16 = load i64, ptr %p16, align 8
  %s24 = shl i64 %w16, 3
  %p17 = getelementptr i8, ptr %words, i64 136
  %w17 = load ptr, ptr %p17, align 8
  %p18 = getelementptr i8, ptr %words, i64 144
  %w18 = load i64, ptr %p18, align 8
  %p19 = getelementptr i8, ptr %words, i64 152
  %w19 = load i64, ptr %p19, align 8
  %s29 = shl i64 %w19, 3
  %.130339.not.i.i = icmp slt i64 %w13, 1
  br i1 %.130339.not.i.i, label %B0.endif.endif.i, label %B40.us.preheader.i.i

B40.us.preheader.i.i:                             ; preds = %0
  %scevgep.i.i = getelementptr i8, ptr %w17, i64 8
  %scevgep3.i.i = getelementptr i8, ptr %w14, i64 32
  br label %B40.us.i.i

B40.us.i.i:                                       ; preds = %B272.us.i.i, %B40.us.preheader.i.i
  %lsr.iv10.i.i = phi i64 [ %w13, %B40.us.preheader.i.i ], [ %lsr.iv.next.i.i, %B272.us.i.i ]
  %lsr.iv4.i.i = phi ptr [ %scevgep3.i.i, %B40.us.preheader.i.i ], [ %scevgep5.i.i, %B272.us.i.i ]
  %lsr.iv.i.i = phi ptr [ %scevgep.i.i, %B40.us.preheader.i.i ], [ %scevgep1.i.i, %B272.us.i.i ]
  %count.2.0344.us.i.i = phi i64 [ 0, %B40.us.preheader.i.i ], [ %count.3.1.us.i.i, %B272.us.i.i ]
  %scevgep9.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -32
  %.229.us.i.i = load i64, ptr %scevgep9.i.i, align 8
  %.230.us.i.i = icmp sgt i64 %.229.us.i.i, -1
  br i1 %.230.us.i.i, label %B70.us.i.i, label %B272.us.i.i

B70.us.i.i:                                       ; preds = %B40.us.i.i
  %.318.us.i.i = getelementptr i8, ptr %w11, i64 %.229.us.i.i
  %.319.us.i.i = load i8, ptr %.318.us.i.i, align 1
  %.322.us.i.i = icmp eq i8 %.319.us.i.i, 0
  br i1 %.322.us.i.i, label %B102.us.i.i, label %B272.us.i.i

B102.us.i.i:                                      ; preds = %B70.us.i.i
  %scevgep8.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -24
  %.387.us.i.i = load i64, ptr %scevgep8.i.i, align 8
  %.401.us.i.i = icmp slt i64 %.387.us.i.i, 0
  %.402.us.i.i = select i1 %.401.us.i.i, i64 %w12, i64 0
  %1 = getelementptr i8, ptr %w11, i64 %.387.us.i.i
  %.416.us.i.i = getelementptr i8, ptr %1, i64 %.402.us.i.i
  %.417.us.i.i = load i8, ptr %.416.us.i.i, align 1
  %.420.us.i.i = icmp eq i8 %.417.us.i.i, 0
  br i1 %.420.us.i.i, label %B134.endif.endif.us.i.i, label %B272.us.i.i

B134.endif.endif.us.i.i:                          ; preds = %B102.us.i.i
  %.621.us.i.i = icmp slt i64 %count.2.0344.us.i.i, 0
  %.622.us.i.i = select i1 %.621.us.i.i, i64 %w15, i64 0
  %.623.us.i.i = add i64 %.622.us.i.i, %count.2.0344.us.i.i
  %.643.us.i.i = mul i64 %.623.us.i.i, %w16
  %2 = getelementptr i64, ptr %w14, i64 %.643.us.i.i
  store i64 %.229.us.i.i, ptr %2, align 8
  %.597.us.1.i.i = load i64, ptr %scevgep8.i.i, align 8
  %.647.us.1.i.i = getelementptr i8, ptr %2, i64 8
  store i64 %.597.us.1.i.i, ptr %.647.us.1.i.i, align 8
  %scevgep7.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -16
  %.597.us.2.i.i = load i64, ptr %scevgep7.i.i, align 8
  %.647.us.2.i.i = getelementptr i8, ptr %2, i64 16
  store i64 %.597.us.2.i.i, ptr %.647.us.2.i.i, align 8
  %scevgep6.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -8
  %.597.us.3.i.i = load i64, ptr %scevgep6.i.i, align 8
  %.647.us.3.i.i = getelementptr i8, ptr %2, i64 24
  store i64 %.597.us.3.i.i, ptr %.647.us.3.i.i, align 8
  %.597.us.4.i.i = load i64, ptr %lsr.iv4.i.i, align 8
  %.647.us.4.i.i = getelementptr i8, ptr %2, i64 32
  store i64 %.597.us.4.i.i, ptr %.647.us.4.i.i, align 8
  %scevgep2.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -8
  %.708.us.i.i = load double, ptr %scevgep2.i.i, align 8
  %.765.us.i.i = load double, ptr %lsr.iv.i.i, align 8
  %.794.us.i.i = select i1 %.621.us.i.i, i64 %w18, i64 0
  %.795.us.i.i = add i64 %.794.us.i.i, %count.2.0344.us.i.i
  %.815.us.i.i = mul i64 %.795.us.i.i, %w19
  %.819.us.i.i = getelementptr double, ptr %w17, i64 %.815.us.i.i
  store double %.708.us.i.i, ptr %.819.us.i.i, align 8
  %.874.us.i.i = getelementptr i8, ptr %.819.us.i.i, i64 8
  store double %.765.us.i.i, ptr %.874.us.i.i, align 8
  %.877.us.i.i = add nsw i64 %count.2.0344.us.i.i, 1
  br label %B272.us.i.i

B272.us.i.i:                                      ; preds = %B134.endif.endif.us.i.i, %B102.us.i.i, %B70.us.i.i, %B40.us.i.i
  %count.3.1.us.i.i = phi i64 [ %count.2.0344.us.i.i, %B40.us.i.i ], [ %count.2.0344.us.i.i, %B70.us.i.i ], [ %.877.us.i.i, %B134.endif.endif.us.i.i ], [ %count.2.0344.us.i.i, %B102.us.i.i ]
  %scevgep1.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 %s29
  %scevgep5.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 %s24
  %lsr.iv.next.i.i = add nsw i64 %lsr.iv10.i.i, -1
  %exitcond.not.i.i = icmp eq i64 %lsr.iv.next.i.i, 0
  br i1 %exitcond.not.i.i, label %B0.endif.endif.i, label %B40.us.i.i

B98.loopexit.i:                                   ; preds = %B825.i, %B148.endif.i, %B100.i
  %count.2.1.lcssa.i = phi i64 [ %count.4.0884.i, %B148.endif.i ], [ %count.4.0884.i, %B100.i ], [ %count.3.2.i, %B825.i ]
  %exitcond985.not.i = icmp eq i64 %w4, %.250.i
  br i1 %exitcond985.not.i, label %_ZN7msf_jax4host4meso7kernels11short_edgesB3v48B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIbLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit, label %B100.i

B100.i:                                           ; preds = %B100.preheader.i, %B98.loopexit.i
  %count.4.0884.i = phi i64 [ %count.2.1.lcssa.i, %B98.loopexit.i ], [ %count.2.0.lcssa.i.i, %B100.preheader.i ]
  %.243832882.i = phi i64 [ %.250.i, %B98.loopexit.i ], [ 0, %B100.preheader.i ]
  %.250.i = add nuw nsw i64 %.243832882.i, 1
  %3 = getelementptr i8, ptr %w11, i64 %.243832882.i
  %.308.i = load i8, ptr %3, align 1
  %.311.i = icmp eq i8 %.308.i, 0
  br i1 %.311.i, label %B98.loopexit.i, label %B148.endif.i

B168.i:                                           ; preds = %B168.lr.ph.i, %B825.i
  %count.2.1819.i = phi i64 [ %count.4.0884.i, %B168.lr.ph.i ], [ %count.3.2.i, %B825.i ]
  %.457776817.i = phi i64 [ 0, %B168.lr.ph.i ], [ %.464.i, %B825.i ]
  %.464.i = add nuw nsw i64 %.457776817.i, 1
  %4 = getelementptr i64, ptr %8, i64 %.457776817.i
  %.81.i.i = load i64, ptr %4, align 8
  %.86.i.i = icmp slt i64 %.81.i.i, 0
  br i1 %.86.i.i, label %B825.i, label %B48.i.i

B48.i.i:                                          ; preds = %B168.i
  %.96.i.i = icmp slt i64 %.81.i.i, %.243832882.i
  br i1 %.96.i.i, label %_ZN7msf_jax4host4meso7kernels12is_met_laterB3v50B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedExx.exit.i, label %B208.endif.endif.endif.endif.i

_ZN7msf_jax4host4meso7kernels12is_met_laterB3v50B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedExx.exit.i: ; preds = %B48.i.i
  %.131.i.i = getelementptr i8, ptr %w11, i64 %.81.i.i
  %.132.i.i = load i8, ptr %.131.i.i, align 1
  %.135.i.not.i = icmp eq i8 %.132.i.i, 0
  br i1 %.135.i.not.i, label %B208.endif.endif.endif.endif.i, label %B825.i

B590.i:                                           ; preds = %B532.B486.loopexit_crit_edge.us.i, %B488.endif.lr.ph.i, %B440.endif.B590_crit_edge.i
  %.80.i.pre-phi.i = phi i64 [ %.pre.i, %B440.endif.B590_crit_edge.i ], [ %.1215.i, %B488.endif.lr.ph.i ], [ %.1215.i, %B532.B486.loopexit_crit_edge.us.i ]
  %common.3.3.lcssa.i = phi i64 [ 0, %B440.endif.B590_crit_edge.i ], [ 0, %B488.endif.lr.ph.i ], [ %.1276.us.lcssa.i, %B532.B486.loopexit_crit_edge.us.i ]
  %.84.i.i = getelementptr i64, ptr %w3, i64 %.80.i.pre-phi.i
  %.85.i.i = load i64, ptr %.84.i.i, align 8
  %.87.not.i.i = icmp eq i64 %.85.i.i, %.11.i25.i
  br i1 %.87.not.i.i, label %B590.endif.i, label %B36.preheader.i.i

B36.preheader.i.i:                                ; preds = %B590.i
  %5 = mul i64 %.11.i.i, %s8
  %scevgep47.i = getelementptr i8, ptr %scevgep46.i, i64 %5
  br label %B36.i.i

B36.i.i:                                          ; preds = %B36.i.i, %B36.preheader.i.i
  %slot.2.0.i.i = phi i64 [ %.90.i.i, %B36.i.i ], [ 0, %B36.preheader.i.i ]
  %.90.i.i = add nuw i64 %slot.2.0.i.i, 1
  %6 = shl i64 %slot.2.0.i.i, 3
  %scevgep48.i = getelementptr i8, ptr %scevgep47.i, i64 %6
  %.145.i.i = load i64, ptr %scevgep48.i, align 8
  %.147.not.i.i = icmp eq i64 %.145.i.i, %.11.i25.i
  br i1 %.147.not.i.i, label %B590.endif.i, label %B36.i.i

B825.i:                                           ; preds = %B590.endif.endif.endif.thread.i, %B208.endif.endif.endif.endif.i, %_ZN7msf_jax4host4meso7kernels12is_met_laterB3v50B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedExx.exit.i, %B168.i
  %count.3.2.i = phi i64 [ %.1972.i, %B590.endif.endif.endif.thread.i ], [ %count.2.1819.i, %B208.endif.endif.endif.endif.i ], [ %count.2.1819.i, %_ZN7msf_jax4host4meso7kernels12is_met_laterB3v50B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedExx.exit.i ], [ %count.2.1819.i, %B168.i ]
  %exitcond984.not.i = icmp eq i64 %.352.i, %.464.i
  br i1 %exitcond984.not.i, label %B98.loopexit.i, label %B168.i

B0.endif.endif.i:                                 ; preds = %B272.us.i.i, %0
  %count.2.0.lcssa.i.i = phi i64 [ 0, %0 ], [ %count.3.1.us.i.i, %B272.us.i.i ]
  %.237877.not.i = icmp slt i64 %w4, 1
  br i1 %.237877.not.i, label %_ZN7msf_jax4host4meso7kernels11short_edgesB3v48B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIbLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit, label %B100.preheader.i

B100.preheader.i:                                 ; preds = %B0.endif.endif.i
  %scevgep.i = getelementptr i8, ptr %w3, i64 24
  %scevgep46.i = getelementptr i8, ptr %w3, i64 8
  br label %B100.i

B148.endif.i:                                     ; preds = %B100.i
  %7 = getelementptr i64, ptr %w6, i64 %.243832882.i
  %.352.i = load i64, ptr %7, align 8
  %.451812.not.i = icmp slt i64 %.352.i, 1
  br i1 %.451812.not.i, label %B98.loopexit.i, label %B168.lr.ph.i

B168.lr.ph.i:                                     ; preds = %B148.endif.i
  %.592.i = mul i64 %.243832882.i, %w5
  %8 = getelementptr i64, ptr %w3, i64 %.592.i
  br label %B168.i

B208.endif.endif.endif.endif.i:                   ; preds = %_ZN7msf_jax4host4meso7kernels12is_met_laterB3v50B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedExx.exit.i, %B48.i.i
  %.11.i.i = tail call i64 @llvm.smin.i64(i64 %.81.i.i, i64 %.243832882.i)
  %.11.i25.i = tail call i64 @llvm.smax.i64(i64 %.81.i.i, i64 %.243832882.i)
  %.68.i.i = mul i64 %.11.i.i, %w2
  %9 = getelementptr double, ptr %w0, i64 %.68.i.i
  %.72.i.i = getelementptr i8, ptr %9, i64 16
  %.73.i.i = load double, ptr %.72.i.i, align 8
  %.121.i.i = mul i64 %.11.i25.i, %w2
  %10 = getelementptr double, ptr %w0, i64 %.121.i.i
  %.125.i.i = getelementptr i8, ptr %10, i64 16
  %.126.i.i = load double, ptr %.125.i.i, align 8
  %.127.i.i = fsub double %.73.i.i, %.126.i.i
  %.235.i.i = fmul double %.127.i.i, %.127.i.i
  %.288.i.i = load double, ptr %9, align 8
  %.341.i.i = load double, ptr %10, align 8
  %.342.i.i = fsub double %.288.i.i, %.341.i.i
  %.450.i.i = fmul double %.342.i.i, %.342.i.i
  %.451.i.i = fadd double %.235.i.i, %.450.i.i
  %.503.i.i = getelementptr i8, ptr %9, i64 8
  %.504.i.i = load double, ptr %.503.i.i, align 8
  %.556.i.i = getelementptr i8, ptr %10, i64 8
  %.557.i.i = load double, ptr %.556.i.i, align 8
  %.558.i.i = fsub double %.504.i.i, %.557.i.i
  %.666.i.i = fmul double %.558.i.i, %.558.i.i
  %.667.i.i = fadd double %.451.i.i, %.666.i.i
  %sqrt.i = tail call double @llvm.sqrt.f64(double %.667.i.i)
  %11 = getelementptr double, ptr %w8, i64 %.11.i.i
  %.784.i = load double, ptr %11, align 8
  %12 = getelementptr double, ptr %w8, i64 %.11.i25.i
  %.815.i = load double, ptr %12, align 8
  %.10.i.i = fcmp olt double %.815.i, %.784.i
  %.11.i26.i = select i1 %.10.i.i, double %.815.i, double %.784.i
  %.845.i = fmul double %w10, %.11.i26.i
  %.847.i = fcmp ult double %sqrt.i, %.845.i
  br i1 %.847.i, label %B440.endif.i, label %B825.i

B440.endif.i:                                     ; preds = %B208.endif.endif.endif.endif.i
  %13 = getelementptr i64, ptr %w6, i64 %.11.i.i
  %.894.i = load i64, ptr %13, align 8
  %.974754.not.i = icmp slt i64 %.894.i, 1
  br i1 %.974754.not.i, label %B440.endif.B590_crit_edge.i, label %B488.endif.lr.ph.i

B440.endif.B590_crit_edge.i:                      ; preds = %B440.endif.i
  %.pre.i = mul i64 %.11.i.i, %w5
  br label %B590.i

B488.endif.lr.ph.i:                               ; preds = %B440.endif.i
  %14 = getelementptr i64, ptr %w6, i64 %.11.i25.i
  %.1051.i = load i64, ptr %14, align 8
  %.1131742.not.i = icmp slt i64 %.1051.i, 1
  %.1215.i = mul i64 %.11.i.i, %w5
  %invariant.gep763.i = getelementptr i64, ptr %w3, i64 %.1215.i
  br i1 %.1131742.not.i, label %B590.i, label %B488.endif.us.preheader.i

B488.endif.us.preheader.i:                        ; preds = %B488.endif.lr.ph.i
  %xtraiter.i = and i64 %.1051.i, 3
  %unroll_iter.i = and i64 %.1051.i, 9223372036854775804
  %15 = mul i64 %.11.i25.i, %s8
  %scevgep34.i = getelementptr i8, ptr %scevgep.i, i64 %15
  %scevgep43.i = getelementptr i8, ptr %w3, i64 %15
  %16 = icmp samesign ult i64 %.1051.i, 4
  %17 = icmp eq i64 %xtraiter.i, 0
  br label %B488.endif.us.i

B488.endif.us.i:                                  ; preds = %B532.B486.loopexit_crit_edge.us.i, %B488.endif.us.preheader.i
  %common.3.3757.us.i = phi i64 [ %.1276.us.lcssa.i, %B532.B486.loopexit_crit_edge.us.i ], [ 0, %B488.endif.us.preheader.i ]
  %.980749755.us.i = phi i64 [ %.987.us.i, %B532.B486.loopexit_crit_edge.us.i ], [ 0, %B488.endif.us.preheader.i ]
  %gep764.us.i = getelementptr i64, ptr %invariant.gep763.i, i64 %.980749755.us.i
  %.1220.us.i = load i64, ptr %gep764.us.i, align 8
  br i1 %16, label %B534.us.epil.preheader.i, label %B534.us.i

B534.us.i:                                        ; preds = %B488.endif.us.i, %B534.us.i
  %common.2.4745.us.i = phi i64 [ %.1276.us.3.i, %B534.us.i ], [ %common.3.3757.us.i, %B488.endif.us.i ]
  %.1137741743.us.i = phi i64 [ %.1144.us.3.i, %B534.us.i ], [ 0, %B488.endif.us.i ]
  %18 = shl i64 %.1137741743.us.i, 3
  %scevgep40.i = getelementptr i8, ptr %scevgep34.i, i64 %18
  %scevgep41.i = getelementptr i8, ptr %scevgep40.i, i64 -24
  %.1271.us.i = load i64, ptr %scevgep41.i, align 8
  %.1272.us.i = icmp eq i64 %.1220.us.i, %.1271.us.i
  %.1275.us.i = zext i1 %.1272.us.i to i64
  %.1276.us.i = add nsw i64 %common.2.4745.us.i, %.1275.us.i
  %scevgep39.i = getelementptr i8, ptr %scevgep40.i, i64 -16
  %.1271.us.1.i = load i64, ptr %scevgep39.i, align 8
  %.1272.us.1.i = icmp eq i64 %.1220.us.i, %.1271.us.1.i
  %.1275.us.1.i = zext i1 %.1272.us.1.i to i64
  %.1276.us.1.i = add nsw i64 %.1276.us.i, %.1275.us.1.i
  %scevgep37.i = getelementptr i8, ptr %scevgep40.i, i64 -8
  %.1271.us.2.i = load i64, ptr %scevgep37.i, align 8
  %.1272.us.2.i = icmp eq i64 %.1220.us.i, %.1271.us.2.i
  %.1275.us.2.i = zext i1 %.1272.us.2.i to i64
  %.1276.us.2.i = add nsw i64 %.1276.us.1.i, %.1275.us.2.i
  %.1144.us.3.i = add nuw nsw i64 %.1137741743.us.i, 4
  %.1271.us.3.i = load i64, ptr %scevgep40.i, align 8
  %.1272.us.3.i = icmp eq i64 %.1220.us.i, %.1271.us.3.i
  %.1275.us.3.i = zext i1 %.1272.us.3.i to i64
  %.1276.us.3.i = add nsw i64 %.1276.us.2.i, %.1275.us.3.i
  %niter.ncmp.3.i = icmp eq i64 %unroll_iter.i, %.1144.us.3.i
  br i1 %niter.ncmp.3.i, label %B532.B486.loopexit_crit_edge.us.unr-lcssa.i, label %B534.us.i

B532.B486.loopexit_crit_edge.us.unr-lcssa.i:      ; preds = %B534.us.i
  br i1 %17, label %B532.B486.loopexit_crit_edge.us.i, label %B534.us.epil.preheader.i

B534.us.epil.preheader.i:                         ; preds = %B532.B486.loopexit_crit_edge.us.unr-lcssa.i, %B488.endif.us.i
  %common.2.4745.us.epil.init.i = phi i64 [ %common.3.3757.us.i, %B488.endif.us.i ], [ %.1276.us.3.i, %B532.B486.loopexit_crit_edge.us.unr-lcssa.i ]
  %.1137741743.us.epil.init.i = phi i64 [ 0, %B488.endif.us.i ], [ %unroll_iter.i, %B532.B486.loopexit_crit_edge.us.unr-lcssa.i ]
  %19 = shl i64 %.1137741743.us.epil.init.i, 3
  %scevgep44.i = getelementptr i8, ptr %scevgep43.i, i64 %19
  br label %B534.us.epil.i

B534.us.epil.i:                                   ; preds = %B534.us.epil.i, %B534.us.epil.preheader.i
  %common.2.4745.us.epil.i = phi i64 [ %common.2.4745.us.epil.init.i, %B534.us.epil.preheader.i ], [ %.1276.us.epil.i, %B534.us.epil.i ]
  %epil.iter.i = phi i64 [ 0, %B534.us.epil.preheader.i ], [ %epil.iter.next.i, %B534.us.epil.i ]
  %20 = shl nuw nsw i64 %epil.iter.i, 3
  %scevgep45.i = getelementptr i8, ptr %scevgep44.i, i64 %20
  %.1271.us.epil.i = load i64, ptr %scevgep45.i, align 8
  %.1272.us.epil.i = icmp eq i64 %.1220.us.i, %.1271.us.epil.i
  %.1275.us.epil.i = zext i1 %.1272.us.epil.i to i64
  %.1276.us.epil.i = add nsw i64 %common.2.4745.us.epil.i, %.1275.us.epil.i
  %epil.iter.next.i = add i64 %epil.iter.i, 1
  %epil.iter.cmp.not.i = icmp eq i64 %xtraiter.i, %epil.iter.next.i
  br i1 %epil.iter.cmp.not.i, label %B532.B486.loopexit_crit_edge.us.i, label %B534.us.epil.i

B532.B486.loopexit_crit_edge.us.i:                ; preds = %B534.us.epil.i, %B532.B486.loopexit_crit_edge.us.unr-lcssa.i
  %.1276.us.lcssa.i = phi i64 [ %.1276.us.3.i, %B532.B486.loopexit_crit_edge.us.unr-lcssa.i ], [ %.1276.us.epil.i, %B534.us.epil.i ]
  %.987.us.i = add nuw nsw i64 %.980749755.us.i, 1
  %exitcond983.not.i = icmp eq i64 %.894.i, %.987.us.i
  br i1 %exitcond983.not.i, label %B590.i, label %B488.endif.us.i

B590.endif.i:                                     ; preds = %B36.i.i, %B590.i
  %slot.3.1.i.i = phi i64 [ 0, %B590.i ], [ %.90.i.i, %B36.i.i ]
  %.1356.i = icmp slt i64 %count.2.1819.i, 0
  %.1357.i = select i1 %.1356.i, i64 %w15, i64 0
  %.1358.i = add i64 %.1357.i, %count.2.1819.i
  %.1378.i = mul i64 %.1358.i, %w16
  %.1382.i = getelementptr i64, ptr %w14, i64 %.1378.i
  store i64 %.11.i.i, ptr %.1382.i, align 8
  %.1438.i = getelementptr i8, ptr %.1382.i, i64 8
  store i64 %.11.i25.i, ptr %.1438.i, align 8
  %.1496.i = getelementptr i8, ptr %.1382.i, i64 32
  store i64 %common.3.3.lcssa.i, ptr %.1496.i, align 8
  %sunkaddr49.i = shl i64 %.11.i.i, 3
  %sunkaddr50.i = getelementptr i8, ptr %w6, i64 %sunkaddr49.i
  %.1531.i = load i64, ptr %sunkaddr50.i, align 8
  %.1534.i = icmp eq i64 %.1531.i, 0
  br i1 %.1534.i, label %B590.endif.endif.thread.i, label %B590.endif.endif.i

B590.endif.endif.i:                               ; preds = %B590.endif.i
  %.1500.i = add nsw i64 %slot.3.1.i.i, 1
  %21 = or i64 %.1531.i, %.1500.i
  %22 = icmp ult i64 %21, 4294967296
  br i1 %22, label %23, label %28

23:                                               ; preds = %B590.endif.endif.i
  %24 = trunc nuw i64 %.1531.i to i32
  %25 = trunc nuw i64 %.1500.i to i32
  %26 = urem i32 %25, %24
  %27 = zext i32 %26 to i64
  br label %30

28:                                               ; preds = %B590.endif.endif.i
  %29 = srem i64 %.1500.i, %.1531.i
  br label %30

30:                                               ; preds = %28, %23
  %31 = phi i64 [ %27, %23 ], [ %29, %28 ]
  %.1552.i = xor i64 %31, %.1531.i
  %.1553.i = icmp slt i64 %.1552.i, 0
  %.1554.i = icmp ne i64 %31, 0
  %.1555.i = and i1 %.1554.i, %.1553.i
  %.1562.i = select i1 %.1555.i, i64 %.1531.i, i64 0
  %spec.select.i = add i64 %.1562.i, %31
  %spec.select.fr.i = freeze i64 %spec.select.i
  %.1598.i = icmp slt i64 %spec.select.fr.i, 0
  %spec.select1017.i = select i1 %.1598.i, i64 %w5, i64 0
  br label %B590.endif.endif.thread.i

B590.endif.endif.thread.i:                        ; preds = %30, %B590.endif.i
  %rem.0993.i = phi i64 [ %spec.select.fr.i, %30 ], [ 0, %B590.endif.i ]
  %32 = phi i64 [ %spec.select1017.i, %30 ], [ 0, %B590.endif.i ]
  %33 = getelementptr i64, ptr %.84.i.i, i64 %rem.0993.i
  %.1621.i = getelementptr i64, ptr %33, i64 %32
  %.1622.i = load i64, ptr %.1621.i, align 8
  %sunkaddr51.i = shl i64 %.1378.i, 3
  %sunkaddr52.i = getelementptr i8, ptr %w14, i64 %sunkaddr51.i
  %sunkaddr53.i = getelementptr i8, ptr %sunkaddr52.i, i64 16
  store i64 %.1622.i, ptr %sunkaddr53.i, align 8
  %.1678.i = add nsw i64 %slot.3.1.i.i, -1
  %.1709.i = load i64, ptr %sunkaddr50.i, align 8
  %.1712.i = icmp eq i64 %.1709.i, 0
  br i1 %.1712.i, label %B590.endif.endif.endif.thread.i, label %B590.endif.endif.else.i

B590.endif.endif.else.i:                          ; preds = %B590.endif.endif.thread.i
  %.1723.i = icmp ne i64 %.1678.i, -9223372036854775808
  %.1724.i = icmp ne i64 %.1709.i, -1
  %.1725.not.i = or i1 %.1723.i, %.1724.i
  br i1 %.1725.not.i, label %B590.endif.endif.else.if.i, label %B590.endif.endif.endif.thread.i

B590.endif.endif.endif.thread.i:                  ; preds = %44, %B590.endif.endif.else.i, %B590.endif.endif.thread.i
  %34 = phi i64 [ 0, %B590.endif.endif.thread.i ], [ %spec.select703.i, %44 ], [ 0, %B590.endif.endif.else.i ]
  %.1801.i = getelementptr i64, ptr %.84.i.i, i64 %34
  %.1802.i = load i64, ptr %.1801.i, align 8
  %sunkaddr58.i = getelementptr i8, ptr %sunkaddr52.i, i64 24
  store i64 %.1802.i, ptr %sunkaddr58.i, align 8
  %.1887.i = select i1 %.1356.i, i64 %w18, i64 0
  %.1888.i = add i64 %.1887.i, %count.2.1819.i
  %.1908.i = mul i64 %.1888.i, %w19
  %.1912.i = getelementptr double, ptr %w17, i64 %.1908.i
  store double %sqrt.i, ptr %.1912.i, align 8
  %.1969.i = getelementptr i8, ptr %.1912.i, i64 8
  store double 0.000000e+00, ptr %.1969.i, align 8
  %.1972.i = add nsw i64 %count.2.1819.i, 1
  br label %B825.i

B590.endif.endif.else.if.i:                       ; preds = %B590.endif.endif.else.i
  %35 = or i64 %.1709.i, %.1678.i
  %36 = icmp ult i64 %35, 4294967296
  br i1 %36, label %37, label %42

37:                                               ; preds = %B590.endif.endif.else.if.i
  %38 = trunc nuw i64 %.1709.i to i32
  %39 = trunc nuw i64 %.1678.i to i32
  %40 = urem i32 %39, %38
  %41 = zext i32 %40 to i64
  br label %44

42:                                               ; preds = %B590.endif.endif.else.if.i
  %43 = srem i64 %.1678.i, %.1709.i
  br label %44

44:                                               ; preds = %42, %37
  %45 = phi i64 [ %41, %37 ], [ %43, %42 ]
  %.1730.i = xor i64 %45, %.1709.i
  %.1731.i = icmp slt i64 %.1730.i, 0
  %.1732.i = icmp ne i64 %45, 0
  %.1733.i = and i1 %.1732.i, %.1731.i
  %.1740.i = select i1 %.1733.i, i64 %.1709.i, i64 0
  %spec.select704.i = add i64 %.1740.i, %45
  %spec.select704.fr.i = freeze i64 %spec.select704.i
  %.1778.i = icmp slt i64 %spec.select704.fr.i, 0
  %.1779.i = select i1 %.1778.i, i64 %w5, i64 0
  %spec.select703.i = add i64 %.1779.i, %spec.select704.fr.i
  br label %B590.endif.endif.endif.thread.i

_ZN7msf_jax4host4meso7kernels11short_edgesB3v48B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIbLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit: ; preds = %B98.loopexit.i, %B0.endif.endif.i
  %count.4.0.lcssa.i = phi i64 [ %count.2.0.lcssa.i.i, %B0.endif.endif.i ], [ %count.2.1.lcssa.i, %B98.loopexit.i ]
  ret i64 %count.4.0.lcssa.i
}

define i64 @msf_jax.host.meso.kernels.wide_edges(ptr readonly %words) local_unnamed_addr {
  %w0 = load ptr, ptr %words, align 8
  %p1 = getelementptr i8, ptr %words, i64 8
  %w1 = load i64, ptr %p1, align 8
  %p2 = getelementptr i8, ptr %words, i64 16
  %w2 = load i64, ptr %p2, align 8
  %p3 = getelementptr i8, ptr %words, i64 24
  %w3 = load ptr, ptr %p3, align 8
  %p4 = getelementptr i8, ptr %words, i64 32
  %w4 = load i64, ptr %p4, align 8
  %p5 = getelementptr i8, ptr %words, i64 40
  %w5 = load i64, ptr %p5, align 8
  %s8 = shl i64 %w5, 3
  %p6 = getelementptr i8, ptr %words, i64 48
  %w6 = load ptr, ptr %p6, align 8
  %p8 = getelementptr i8, ptr %words, i64 64
  %w8 = load ptr, ptr %p8, align 8
  %p10 = getelementptr i8, ptr %words, i64 80
  %w10 = load double, ptr %p10, align 8
  %p11 = getelementptr i8, ptr %words, i64 88
  %w11 = load double, ptr %p11, align 8
  %p12 = getelementptr i8, ptr %words, i64 96
  %w12 = load ptr, ptr %p12, align 8
  %p13 = getelementptr i8, ptr %words, i64 104
  %w13 = load i64, ptr %p13, align 8
  %p14 = getelementptr i8, ptr %words, i64 112
  %w14 = load i64, ptr %p14, align 8
  %p15 = getelementptr i8, ptr %words, i64 120
  %w15 = load ptr, ptr %p15, align 8
  %p16 = getelementptr i8, ptr %words, i64 128
  %w16 = load i64, ptr %p16, align 8
  %p17 = getelementptr i8, ptr %words, i64 136
  %w17 = load i64, ptr %p17, align 8
  %s25 = shl i64 %w17, 3
  %p18 = getelementptr i8, ptr %words, i64 144
  %w18 = load ptr, ptr %p18, align 8
  %p19 = getelementptr i8, ptr %words, i64 152
  %w19 = load i64, ptr %p19, align 8
  %p20 = getelementptr i8, ptr %words, i64 160
  %w20 = load i64, ptr %p20, align 8
  %s30 = shl i64 %w20, 3
  %.130339.not.i.i = icmp slt i64 %w14, 1
  br i1 %.130339.not.i.i, label %B0.endif.endif.i, label %B40.us.preheader.i.i

B40.us.preheader.i.i:                             ; preds = %0
  %scevgep.i.i = getelementptr i8, ptr %w18, i64 8
  %scevgep3.i.i = getelementptr i8, ptr %w15, i64 32
  br label %B40.us.i.i

B40.us.i.i:                                       ; preds = %B272.us.i.i, %B40.us.preheader.i.i
  %lsr.iv10.i.i = phi i64 [ %w14, %B40.us.preheader.i.i ], [ %lsr.iv.next.i.i, %B272.us.i.i ]
  %lsr.iv4.i.i = phi ptr [ %scevgep3.i.i, %B40.us.preheader.i.i ], [ %scevgep5.i.i, %B272.us.i.i ]
  %lsr.iv.i.i = phi ptr [ %scevgep.i.i, %B40.us.preheader.i.i ], [ %scevgep1.i.i, %B272.us.i.i ]
  %count.2.0344.us.i.i = phi i64 [ 0, %B40.us.preheader.i.i ], [ %count.3.1.us.i.i, %B272.us.i.i ]
  %scevgep9.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -32
  %.229.us.i.i = load i64, ptr %scevgep9.i.i, align 8
  %.230.us.i.i = icmp sgt i64 %.229.us.i.i, -1
  br i1 %.230.us.i.i, label %B70.us.i.i, label %B272.us.i.i

B70.us.i.i:                                       ; preds = %B40.us.i.i
  %.318.us.i.i = getelementptr i8, ptr %w12, i64 %.229.us.i.i
  %.319.us.i.i = load i8, ptr %.318.us.i.i, align 1
  %.322.us.i.i = icmp eq i8 %.319.us.i.i, 0
  br i1 %.322.us.i.i, label %B102.us.i.i, label %B272.us.i.i

B102.us.i.i:                                      ; preds = %B70.us.i.i
  %scevgep8.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -24
  %.387.us.i.i = load i64, ptr %scevgep8.i.i, align 8
  %.401.us.i.i = icmp slt i64 %.387.us.i.i, 0
  %.402.us.i.i = select i1 %.401.us.i.i, i64 %w13, i64 0
  %1 = getelementptr i8, ptr %w12, i64 %.387.us.i.i
  %.416.us.i.i = getelementptr i8, ptr %1, i64 %.402.us.i.i
  %.417.us.i.i = load i8, ptr %.416.us.i.i, align 1
  %.420.us.i.i = icmp eq i8 %.417.us.i.i, 0
  br i1 %.420.us.i.i, label %B134.endif.endif.us.i.i, label %B272.us.i.i

B134.endif.endif.us.i.i:                          ; preds = %B102.us.i.i
  %.621.us.i.i = icmp slt i64 %count.2.0344.us.i.i, 0
  %.622.us.i.i = select i1 %.621.us.i.i, i64 %w16, i64 0
  %.623.us.i.i = add i64 %.622.us.i.i, %count.2.0344.us.i.i
  %.643.us.i.i = mul i64 %.623.us.i.i, %w17
  %2 = getelementptr i64, ptr %w15, i64 %.643.us.i.i
  store i64 %.229.us.i.i, ptr %2, align 8
  %.597.us.1.i.i = load i64, ptr %scevgep8.i.i, align 8
  %.647.us.1.i.i = getelementptr i8, ptr %2, i64 8
  store i64 %.597.us.1.i.i, ptr %.647.us.1.i.i, align 8
  %scevgep7.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -16
  %.597.us.2.i.i = load i64, ptr %scevgep7.i.i, align 8
  %.647.us.2.i.i = getelementptr i8, ptr %2, i64 16
  store i64 %.597.us.2.i.i, ptr %.647.us.2.i.i, align 8
  %scevgep6.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 -8
  %.597.us.3.i.i = load i64, ptr %scevgep6.i.i, align 8
  %.647.us.3.i.i = getelementptr i8, ptr %2, i64 24
  store i64 %.597.us.3.i.i, ptr %.647.us.3.i.i, align 8
  %.597.us.4.i.i = load i64, ptr %lsr.iv4.i.i, align 8
  %.647.us.4.i.i = getelementptr i8, ptr %2, i64 32
  store i64 %.597.us.4.i.i, ptr %.647.us.4.i.i, align 8
  %scevgep2.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -8
  %.708.us.i.i = load double, ptr %scevgep2.i.i, align 8
  %.765.us.i.i = load double, ptr %lsr.iv.i.i, align 8
  %.794.us.i.i = select i1 %.621.us.i.i, i64 %w19, i64 0
  %.795.us.i.i = add i64 %.794.us.i.i, %count.2.0344.us.i.i
  %.815.us.i.i = mul i64 %.795.us.i.i, %w20
  %.819.us.i.i = getelementptr double, ptr %w18, i64 %.815.us.i.i
  store double %.708.us.i.i, ptr %.819.us.i.i, align 8
  %.874.us.i.i = getelementptr i8, ptr %.819.us.i.i, i64 8
  store double %.765.us.i.i, ptr %.874.us.i.i, align 8
  %.877.us.i.i = add nsw i64 %count.2.0344.us.i.i, 1
  br label %B272.us.i.i

B272.us.i.i:                                      ; preds = %B134.endif.endif.us.i.i, %B102.us.i.i, %B70.us.i.i, %B40.us.i.i
  %count.3.1.us.i.i = phi i64 [ %count.2.0344.us.i.i, %B40.us.i.i ], [ %count.2.0344.us.i.i, %B70.us.i.i ], [ %.877.us.i.i, %B134.endif.endif.us.i.i ], [ %count.2.0344.us.i.i, %B102.us.i.i ]
  %scevgep1.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 %s30
  %scevgep5.i.i = getelementptr i8, ptr %lsr.iv4.i.i, i64 %s25
  %lsr.iv.next.i.i = add nsw i64 %lsr.iv10.i.i, -1
  %exitcond.not.i.i = icmp eq i64 %lsr.iv.next.i.i, 0
  br i1 %exitcond.not.i.i, label %B0.endif.endif.i, label %B40.us.i.i

B98.loopexit.i:                                   ; preds = %B869.i, %B148.endif.i, %B100.i
  %count.2.1.lcssa.i = phi i64 [ %count.3.0722.i, %B148.endif.i ], [ %count.3.0722.i, %B100.i ], [ %count.4.2.i, %B869.i ]
  %exitcond792.not.i = icmp eq i64 %w4, %.253.i
  br i1 %exitcond792.not.i, label %_ZN7msf_jax4host4meso7kernels10wide_edgesB3v55B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIbLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit, label %B100.i

B100.i:                                           ; preds = %B100.preheader.i, %B98.loopexit.i
  %count.3.0722.i = phi i64 [ %count.2.1.lcssa.i, %B98.loopexit.i ], [ %count.2.0.lcssa.i.i, %B100.preheader.i ]
  %.246698720.i = phi i64 [ %.253.i, %B98.loopexit.i ], [ 0, %B100.preheader.i ]
  %.253.i = add nuw nsw i64 %.246698720.i, 1
  %3 = getelementptr i8, ptr %w12, i64 %.246698720.i
  %.311.i = load i8, ptr %3, align 1
  %.314.i = icmp eq i8 %.311.i, 0
  br i1 %.314.i, label %B98.loopexit.i, label %B148.endif.i

B168.i:                                           ; preds = %B168.lr.ph.i, %B869.i
  %count.2.1686.i = phi i64 [ %count.3.0722.i, %B168.lr.ph.i ], [ %count.4.2.i, %B869.i ]
  %.460674684.i = phi i64 [ 0, %B168.lr.ph.i ], [ %.467.i, %B869.i ]
  %.467.i = add nuw nsw i64 %.460674684.i, 1
  %4 = getelementptr i64, ptr %8, i64 %.460674684.i
  %.81.i.i = load i64, ptr %4, align 8
  %.86.i.i = icmp slt i64 %.81.i.i, 0
  br i1 %.86.i.i, label %B869.i, label %B48.i.i

B48.i.i:                                          ; preds = %B168.i
  %.96.i.i = icmp slt i64 %.81.i.i, %.246698720.i
  br i1 %.96.i.i, label %_ZN7msf_jax4host4meso7kernels12is_met_laterB3v50B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedExx.exit.i, label %B208.endif.endif.endif.endif.i

_ZN7msf_jax4host4meso7kernels12is_met_laterB3v50B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedExx.exit.i: ; preds = %B48.i.i
  %.131.i.i = getelementptr i8, ptr %w12, i64 %.81.i.i
  %.132.i.i = load i8, ptr %.131.i.i, align 1
  %.135.i.not.i = icmp eq i8 %.132.i.i, 0
  br i1 %.135.i.not.i, label %B208.endif.endif.endif.endif.i, label %B869.i

B440.i:                                           ; preds = %B208.endif.endif.endif.endif.i
  %.80.i.i = mul i64 %.11.i.i, %w5
  %.84.i.i = getelementptr i64, ptr %w3, i64 %.80.i.i
  %.85.i.i = load i64, ptr %.84.i.i, align 8
  %.87.not.i.i = icmp eq i64 %.85.i.i, %.11.i49.i
  br i1 %.87.not.i.i, label %B440.endif.i, label %B36.preheader.i.i

B36.preheader.i.i:                                ; preds = %B440.i
  %5 = mul i64 %s8, %.11.i.i
  %scevgep160.i = getelementptr i8, ptr %scevgep.i, i64 %5
  br label %B36.i.i

B36.i.i:                                          ; preds = %B36.i.i, %B36.preheader.i.i
  %slot.2.0.i.i = phi i64 [ %.90.i.i, %B36.i.i ], [ 0, %B36.preheader.i.i ]
  %.90.i.i = add nuw i64 %slot.2.0.i.i, 1
  %6 = shl i64 %slot.2.0.i.i, 3
  %scevgep161.i = getelementptr i8, ptr %scevgep160.i, i64 %6
  %.145.i.i = load i64, ptr %scevgep161.i, align 8
  %.147.not.i.i = icmp eq i64 %.145.i.i, %.11.i49.i
  br i1 %.147.not.i.i, label %B440.endif.i, label %B36.i.i

B869.i:                                           ; preds = %B676.endif.endif.i, %B440.endif.endif.endif.endif.endif.i, %B208.endif.endif.endif.endif.i, %_ZN7msf_jax4host4meso7kernels12is_met_laterB3v50B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedExx.exit.i, %B168.i
  %count.4.2.i = phi i64 [ %count.2.1686.i, %B208.endif.endif.endif.endif.i ], [ %count.2.1686.i, %B440.endif.endif.endif.endif.endif.i ], [ %.1705.i, %B676.endif.endif.i ], [ %count.2.1686.i, %_ZN7msf_jax4host4meso7kernels12is_met_laterB3v50B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedExx.exit.i ], [ %count.2.1686.i, %B168.i ]
  %exitcond.not.i = icmp eq i64 %.355.i, %.467.i
  br i1 %exitcond.not.i, label %B98.loopexit.i, label %B168.i

B0.endif.endif.i:                                 ; preds = %B272.us.i.i, %0
  %count.2.0.lcssa.i.i = phi i64 [ 0, %0 ], [ %count.3.1.us.i.i, %B272.us.i.i ]
  %.240719.not.i = icmp slt i64 %w4, 1
  br i1 %.240719.not.i, label %_ZN7msf_jax4host4meso7kernels10wide_edgesB3v55B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIbLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit, label %B100.preheader.i

B100.preheader.i:                                 ; preds = %B0.endif.endif.i
  %scevgep.i = getelementptr i8, ptr %w3, i64 8
  br label %B100.i

B148.endif.i:                                     ; preds = %B100.i
  %7 = getelementptr i64, ptr %w6, i64 %.246698720.i
  %.355.i = load i64, ptr %7, align 8
  %.454683.not.i = icmp slt i64 %.355.i, 1
  br i1 %.454683.not.i, label %B98.loopexit.i, label %B168.lr.ph.i

B168.lr.ph.i:                                     ; preds = %B148.endif.i
  %.595.i = mul i64 %.246698720.i, %w5
  %8 = getelementptr i64, ptr %w3, i64 %.595.i
  br label %B168.i

B208.endif.endif.endif.endif.i:                   ; preds = %_ZN7msf_jax4host4meso7kernels12is_met_laterB3v50B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedExx.exit.i, %B48.i.i
  %.11.i.i = tail call i64 @llvm.smin.i64(i64 %.81.i.i, i64 %.246698720.i)
  %.11.i49.i = tail call i64 @llvm.smax.i64(i64 %.81.i.i, i64 %.246698720.i)
  %.68.i53.i = mul i64 %.11.i49.i, %w2
  %9 = getelementptr double, ptr %w0, i64 %.68.i53.i
  %.72.i54.i = getelementptr i8, ptr %9, i64 16
  %.73.i55.i = load double, ptr %.72.i54.i, align 8
  %.121.i59.i = mul i64 %.11.i.i, %w2
  %10 = getelementptr double, ptr %w0, i64 %.121.i59.i
  %.125.i60.i = getelementptr i8, ptr %10, i64 16
  %.126.i61.i = load double, ptr %.125.i60.i, align 8
  %.127.i62.i = fsub double %.73.i55.i, %.126.i61.i
  %.235.i76.i = fmul double %.127.i62.i, %.127.i62.i
  %.288.i77.i = load double, ptr %9, align 8
  %.341.i78.i = load double, ptr %10, align 8
  %.342.i79.i = fsub double %.288.i77.i, %.341.i78.i
  %.450.i83.i = fmul double %.342.i79.i, %.342.i79.i
  %.451.i84.i = fadd double %.235.i76.i, %.450.i83.i
  %.503.i85.i = getelementptr i8, ptr %9, i64 8
  %.504.i86.i = load double, ptr %.503.i85.i, align 8
  %.556.i87.i = getelementptr i8, ptr %10, i64 8
  %.557.i88.i = load double, ptr %.556.i87.i, align 8
  %.558.i89.i = fsub double %.504.i86.i, %.557.i88.i
  %.666.i95.i = fmul double %.558.i89.i, %.558.i89.i
  %.667.i96.i = fadd double %.451.i84.i, %.666.i95.i
  %sqrt.i = tail call double @llvm.sqrt.f64(double %.667.i96.i)
  %11 = getelementptr double, ptr %w8, i64 %.11.i.i
  %.788.i = load double, ptr %11, align 8
  %12 = getelementptr double, ptr %w8, i64 %.11.i49.i
  %.819.i = load double, ptr %12, align 8
  %.10.i.i = fcmp olt double %.819.i, %.788.i
  %.11.i97.i = select i1 %.10.i.i, double %.819.i, double %.788.i
  %.849.i = fmul double %w10, %.11.i97.i
  %.850.i = fcmp ugt double %sqrt.i, %.849.i
  br i1 %.850.i, label %B440.i, label %B869.i

B440.endif.i:                                     ; preds = %B36.i.i, %B440.i
  %slot.3.1.i.i = phi i64 [ 0, %B440.i ], [ %.90.i.i, %B36.i.i ]
  %13 = getelementptr i64, ptr %w6, i64 %.11.i.i
  %.931.i = load i64, ptr %13, align 8
  %.934.i = icmp eq i64 %.931.i, 0
  br i1 %.934.i, label %B440.endif.endif.endif.thread.i, label %B440.endif.endif.i

B440.endif.endif.i:                               ; preds = %B440.endif.i
  %.900.i = add nsw i64 %slot.3.1.i.i, 1
  %14 = or i64 %.900.i, %.931.i
  %15 = icmp ult i64 %14, 4294967296
  br i1 %15, label %16, label %21

16:                                               ; preds = %B440.endif.endif.i
  %17 = trunc nuw i64 %.931.i to i32
  %18 = trunc nuw i64 %.900.i to i32
  %19 = urem i32 %18, %17
  %20 = zext i32 %19 to i64
  br label %23

21:                                               ; preds = %B440.endif.endif.i
  %22 = srem i64 %.900.i, %.931.i
  br label %23

23:                                               ; preds = %21, %16
  %24 = phi i64 [ %20, %16 ], [ %22, %21 ]
  %.952.i = xor i64 %24, %.931.i
  %.953.i = icmp slt i64 %.952.i, 0
  %.954.i = icmp ne i64 %24, 0
  %.955.i = and i1 %.954.i, %.953.i
  %.962.i = select i1 %.955.i, i64 %.931.i, i64 0
  %spec.select.i = add i64 %.962.i, %24
  %spec.select.fr.i = freeze i64 %spec.select.i
  %.998.i = icmp slt i64 %spec.select.fr.i, 0
  %spec.select857.i = select i1 %.998.i, i64 %w5, i64 0
  %25 = getelementptr i64, ptr %.84.i.i, i64 %spec.select.fr.i
  %.1021805.i = getelementptr i64, ptr %25, i64 %spec.select857.i
  %.1022806.i = load i64, ptr %.1021805.i, align 8
  %.1023807.i = add nsw i64 %slot.3.1.i.i, -1
  %.1068.i = icmp ne i64 %.1023807.i, -9223372036854775808
  %.1069.i = icmp ne i64 %.931.i, -1
  %.1070.not.i = or i1 %.1068.i, %.1069.i
  br i1 %.1070.not.i, label %B440.endif.endif.else.if.i, label %B440.endif.endif.endif.thread.i

B440.endif.endif.endif.thread.i:                  ; preds = %36, %23, %B440.endif.i
  %.1145.i = phi i64 [ %.85.i.i, %23 ], [ %.1145.pre.i, %36 ], [ %.85.i.i, %B440.endif.i ]
  %.1022809.i = phi i64 [ %.1022806.i, %23 ], [ %.1022806.i, %36 ], [ %.85.i.i, %B440.endif.i ]
  %.99.i.i.i = icmp slt i64 %.1022809.i, 0
  %.100.i.i.i = select i1 %.99.i.i.i, i64 %w1, i64 0
  %.101.i.i.i = add i64 %.100.i.i.i, %.1022809.i
  %.121.i.i.i = mul i64 %.101.i.i.i, %w2
  %26 = getelementptr double, ptr %w0, i64 %.121.i.i.i
  %.125.i.i.i = getelementptr i8, ptr %26, i64 16
  %.126.i.i.i = load double, ptr %.125.i.i.i, align 8
  %.127.i.i.i = fsub double %.126.i61.i, %.126.i.i.i
  %.235.i.i.i = fmul double %.127.i.i.i, %.127.i.i.i
  %.341.i.i.i = load double, ptr %26, align 8
  %.342.i.i.i = fsub double %.341.i78.i, %.341.i.i.i
  %.450.i.i.i = fmul double %.342.i.i.i, %.342.i.i.i
  %.451.i.i.i = fadd double %.235.i.i.i, %.450.i.i.i
  %.556.i.i.i = getelementptr i8, ptr %26, i64 8
  %.557.i.i.i = load double, ptr %.556.i.i.i, align 8
  %.558.i.i.i = fsub double %.557.i88.i, %.557.i.i.i
  %.666.i.i.i = fmul double %.558.i.i.i, %.558.i.i.i
  %.667.i.i.i = fadd double %.451.i.i.i, %.666.i.i.i
  %.127.i60.i.i = fsub double %.73.i55.i, %.126.i.i.i
  %.235.i74.i.i = fmul double %.127.i60.i.i, %.127.i60.i.i
  %.342.i77.i.i = fsub double %.288.i77.i, %.341.i.i.i
  %.450.i81.i.i = fmul double %.342.i77.i.i, %.342.i77.i.i
  %.451.i82.i.i = fadd double %.235.i74.i.i, %.450.i81.i.i
  %.558.i87.i.i = fsub double %.504.i86.i, %.557.i.i.i
  %.666.i93.i.i = fmul double %.558.i87.i.i, %.558.i87.i.i
  %.667.i94.i.i = fadd double %.451.i82.i.i, %.666.i93.i.i
  %.98.i.i = fmul double %.667.i.i.i, %.667.i94.i.i
  %.105.i.i = fcmp ogt double %.98.i.i, 0.000000e+00
  br i1 %.105.i.i, label %B120.endif.endif.i.i, label %B440.endif.endif.endif.endif.i

B120.endif.endif.i.i:                             ; preds = %B440.endif.endif.endif.thread.i
  %sqrt.i.i = tail call double @llvm.sqrt.f64(double %.98.i.i)
  %.235.i27.i.i = fmul double %.127.i.i.i, %.127.i60.i.i
  %.450.i34.i.i = fmul double %.342.i.i.i, %.342.i77.i.i
  %.451.i35.i.i = fadd double %.235.i27.i.i, %.450.i34.i.i
  %.666.i46.i.i = fmul double %.558.i.i.i, %.558.i87.i.i
  %.667.i47.i.i = fadd double %.451.i35.i.i, %.666.i46.i.i
  %.153.i98.i = fdiv double %.667.i47.i.i, %sqrt.i.i
  br label %B440.endif.endif.endif.endif.i

B440.endif.endif.else.if.i:                       ; preds = %23
  %27 = or i64 %.1023807.i, %.931.i
  %28 = icmp ult i64 %27, 4294967296
  br i1 %28, label %29, label %34

29:                                               ; preds = %B440.endif.endif.else.if.i
  %30 = trunc nuw i64 %.931.i to i32
  %31 = trunc nuw i64 %.1023807.i to i32
  %32 = urem i32 %31, %30
  %33 = zext i32 %32 to i64
  br label %36

34:                                               ; preds = %B440.endif.endif.else.if.i
  %35 = srem i64 %.1023807.i, %.931.i
  br label %36

36:                                               ; preds = %34, %29
  %37 = phi i64 [ %33, %29 ], [ %35, %34 ]
  %.1075.i = xor i64 %37, %.931.i
  %.1076.i = icmp slt i64 %.1075.i, 0
  %.1077.i = icmp ne i64 %37, 0
  %.1078.i = and i1 %.1077.i, %.1076.i
  %.1085.i = select i1 %.1078.i, i64 %.931.i, i64 0
  %spec.select600.i = add i64 %.1085.i, %37
  %spec.select600.fr.i = freeze i64 %spec.select600.i
  %.1121.i = icmp slt i64 %spec.select600.fr.i, 0
  %.1122.i = select i1 %.1121.i, i64 %w5, i64 0
  %38 = getelementptr i64, ptr %.84.i.i, i64 %.1122.i
  %.1144.phi.trans.insert.i = getelementptr i64, ptr %38, i64 %spec.select600.fr.i
  %.1145.pre.i = load i64, ptr %.1144.phi.trans.insert.i, align 8
  br label %B440.endif.endif.endif.thread.i

B440.endif.endif.endif.endif.i:                   ; preds = %B120.endif.endif.i.i, %B440.endif.endif.endif.thread.i
  %"$phi166.0.2.0.i.i" = phi double [ %.153.i98.i, %B120.endif.endif.i.i ], [ 1.000000e+00, %B440.endif.endif.endif.thread.i ]
  %.99.i.i105.i = icmp slt i64 %.1145.i, 0
  %.100.i.i106.i = select i1 %.99.i.i105.i, i64 %w1, i64 0
  %.101.i.i107.i = add i64 %.100.i.i106.i, %.1145.i
  %.121.i.i108.i = mul i64 %.101.i.i107.i, %w2
  %39 = getelementptr double, ptr %w0, i64 %.121.i.i108.i
  %.125.i.i109.i = getelementptr i8, ptr %39, i64 16
  %.126.i.i110.i = load double, ptr %.125.i.i109.i, align 8
  %.127.i.i111.i = fsub double %.126.i61.i, %.126.i.i110.i
  %.235.i.i112.i = fmul double %.127.i.i111.i, %.127.i.i111.i
  %.341.i.i114.i = load double, ptr %39, align 8
  %.342.i.i115.i = fsub double %.341.i78.i, %.341.i.i114.i
  %.450.i.i116.i = fmul double %.342.i.i115.i, %.342.i.i115.i
  %.451.i.i117.i = fadd double %.235.i.i112.i, %.450.i.i116.i
  %.556.i.i120.i = getelementptr i8, ptr %39, i64 8
  %.557.i.i121.i = load double, ptr %.556.i.i120.i, align 8
  %.558.i.i122.i = fsub double %.557.i88.i, %.557.i.i121.i
  %.666.i.i123.i = fmul double %.558.i.i122.i, %.558.i.i122.i
  %.667.i.i124.i = fadd double %.451.i.i117.i, %.666.i.i123.i
  %.127.i60.i131.i = fsub double %.73.i55.i, %.126.i.i110.i
  %.235.i74.i132.i = fmul double %.127.i60.i131.i, %.127.i60.i131.i
  %.342.i77.i134.i = fsub double %.288.i77.i, %.341.i.i114.i
  %.450.i81.i135.i = fmul double %.342.i77.i134.i, %.342.i77.i134.i
  %.451.i82.i136.i = fadd double %.235.i74.i132.i, %.450.i81.i135.i
  %.558.i87.i139.i = fsub double %.504.i86.i, %.557.i.i121.i
  %.666.i93.i140.i = fmul double %.558.i87.i139.i, %.558.i87.i139.i
  %.667.i94.i141.i = fadd double %.451.i82.i136.i, %.666.i93.i140.i
  %.98.i142.i = fmul double %.667.i.i124.i, %.667.i94.i141.i
  %.105.i143.i = fcmp ogt double %.98.i142.i, 0.000000e+00
  br i1 %.105.i143.i, label %B120.endif.endif.i145.i, label %B440.endif.endif.endif.endif.endif.i

B120.endif.endif.i145.i:                          ; preds = %B440.endif.endif.endif.endif.i
  %sqrt.i146.i = tail call double @llvm.sqrt.f64(double %.98.i142.i)
  %.235.i27.i147.i = fmul double %.127.i.i111.i, %.127.i60.i131.i
  %.450.i34.i148.i = fmul double %.342.i.i115.i, %.342.i77.i134.i
  %.451.i35.i149.i = fadd double %.235.i27.i147.i, %.450.i34.i148.i
  %.666.i46.i150.i = fmul double %.558.i.i122.i, %.558.i87.i139.i
  %.667.i47.i151.i = fadd double %.451.i35.i149.i, %.666.i46.i150.i
  %.153.i152.i = fdiv double %.667.i47.i151.i, %sqrt.i146.i
  br label %B440.endif.endif.endif.endif.endif.i

B440.endif.endif.endif.endif.endif.i:             ; preds = %B120.endif.endif.i145.i, %B440.endif.endif.endif.endif.i
  %"$phi166.0.2.0.i144.i" = phi double [ %.153.i152.i, %B120.endif.endif.i145.i ], [ 1.000000e+00, %B440.endif.endif.endif.endif.i ]
  %.1226.i = fcmp olt double %"$phi166.0.2.0.i.i", %w11
  %.1233.i = fcmp olt double %"$phi166.0.2.0.i144.i", %w11
  %or.cond.i = and i1 %.1226.i, %.1233.i
  br i1 %or.cond.i, label %B676.endif.endif.i, label %B869.i

B676.endif.endif.i:                               ; preds = %B440.endif.endif.endif.endif.endif.i
  %.1239.i = fcmp ole double %"$phi166.0.2.0.i.i", %"$phi166.0.2.0.i144.i"
  %"$phi676.2.2.4.i" = select i1 %.1239.i, i64 %.1022809.i, i64 %.1145.i
  %.1300.i = icmp slt i64 %count.2.1686.i, 0
  %.1301.i = select i1 %.1300.i, i64 %w16, i64 0
  %.1302.i = add i64 %.1301.i, %count.2.1686.i
  %.1322.i = mul i64 %.1302.i, %w17
  %.1326.i = getelementptr i64, ptr %w15, i64 %.1322.i
  store i64 %.11.i.i, ptr %.1326.i, align 8
  %.1381.i = getelementptr i8, ptr %.1326.i, i64 8
  store i64 %.11.i49.i, ptr %.1381.i, align 8
  %.1436.i = getelementptr i8, ptr %.1326.i, i64 16
  store i64 %.1022809.i, ptr %.1436.i, align 8
  %.1491.i = getelementptr i8, ptr %.1326.i, i64 24
  store i64 %.1145.i, ptr %.1491.i, align 8
  %.1546.i = getelementptr i8, ptr %.1326.i, i64 32
  store i64 %"$phi676.2.2.4.i", ptr %.1546.i, align 8
  %.46.i.i = icmp slt i64 %"$phi676.2.2.4.i", 0
  %.47.i.i = select i1 %.46.i.i, i64 %w1, i64 0
  %.48.i.i = add i64 %.47.i.i, %"$phi676.2.2.4.i"
  %.68.i.i = mul i64 %.48.i.i, %w2
  %40 = getelementptr double, ptr %w0, i64 %.68.i.i
  %.72.i.i = getelementptr i8, ptr %40, i64 16
  %.73.i.i = load double, ptr %.72.i.i, align 8
  %sunkaddr162.i = shl i64 %.121.i59.i, 3
  %sunkaddr163.i = getelementptr i8, ptr %w0, i64 %sunkaddr162.i
  %sunkaddr164.i = getelementptr i8, ptr %sunkaddr163.i, i64 16
  %.126.i.i = load double, ptr %sunkaddr164.i, align 8
  %.127.i.i = fsub double %.73.i.i, %.126.i.i
  %sunkaddr165.i = shl i64 %.68.i53.i, 3
  %sunkaddr166.i = getelementptr i8, ptr %w0, i64 %sunkaddr165.i
  %sunkaddr167.i = getelementptr i8, ptr %sunkaddr166.i, i64 16
  %.180.i.i = load double, ptr %sunkaddr167.i, align 8
  %.234.i.i = fsub double %.180.i.i, %.126.i.i
  %.235.i.i = fmul double %.127.i.i, %.234.i.i
  %.288.i.i = load double, ptr %40, align 8
  %.341.i.i = load double, ptr %sunkaddr163.i, align 8
  %.342.i.i = fsub double %.288.i.i, %.341.i.i
  %.395.i.i = load double, ptr %sunkaddr166.i, align 8
  %.449.i.i = fsub double %.395.i.i, %.341.i.i
  %.450.i.i = fmul double %.342.i.i, %.449.i.i
  %.451.i.i = fadd double %.235.i.i, %.450.i.i
  %.503.i.i = getelementptr i8, ptr %40, i64 8
  %.504.i.i = load double, ptr %.503.i.i, align 8
  %sunkaddr174.i = getelementptr i8, ptr %sunkaddr163.i, i64 8
  %.557.i.i = load double, ptr %sunkaddr174.i, align 8
  %.558.i.i = fsub double %.504.i.i, %.557.i.i
  %sunkaddr177.i = getelementptr i8, ptr %sunkaddr166.i, i64 8
  %.611.i.i = load double, ptr %sunkaddr177.i, align 8
  %.665.i.i = fsub double %.611.i.i, %.557.i.i
  %.666.i.i = fmul double %.558.i.i, %.665.i.i
  %.667.i.i = fadd double %.451.i.i, %.666.i.i
  %.1591.i = fdiv double %.667.i.i, %.667.i96.i
  %.1622.i = select i1 %.1300.i, i64 %w19, i64 0
  %.1623.i = add i64 %.1622.i, %count.2.1686.i
  %.1643.i = mul i64 %.1623.i, %w20
  %.1647.i = getelementptr double, ptr %w18, i64 %.1643.i
  store double %sqrt.i, ptr %.1647.i, align 8
  %.1702.i = getelementptr i8, ptr %.1647.i, i64 8
  store double %.1591.i, ptr %.1702.i, align 8
  %.1705.i = add nsw i64 %count.2.1686.i, 1
  br label %B869.i

_ZN7msf_jax4host4meso7kernels10wide_edgesB3v55B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIbLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit: ; preds = %B98.loopexit.i, %B0.endif.endif.i
  %count.3.0.lcssa.i = phi i64 [ %count.2.0.lcssa.i.i, %B0.endif.endif.i ], [ %count.2.1.lcssa.i, %B98.loopexit.i ]
  ret i64 %count.3.0.lcssa.i
}

define noundef i64 @msf_jax.host.meso.kernels.apart(ptr readonly %words) local_unnamed_addr {
  %w0 = load ptr, ptr %words, align 8
  %p1 = getelementptr i8, ptr %words, i64 8
  %w1 = load i64, ptr %p1, align 8
  %p2 = getelementptr i8, ptr %words, i64 16
  %w2 = load i64, ptr %p2, align 8
  %s3 = shl i64 %w2, 3
  %p3 = getelementptr i8, ptr %words, i64 24
  %w3 = load ptr, ptr %p3, align 8
  %p4 = getelementptr i8, ptr %words, i64 32
  %w4 = load i64, ptr %p4, align 8
  %p5 = getelementptr i8, ptr %words, i64 40
  %w5 = load ptr, ptr %p5, align 8
  %p6 = getelementptr i8, ptr %words, i64 48
  %w6 = load i64, ptr %p6, align 8
  %p7 = getelementptr i8, ptr %words, i64 56
  %w7 = load ptr, ptr %p7, align 8
  %p8 = getelementptr i8, ptr %words, i64 64
  %w8 = load i64, ptr %p8, align 8
  %.87297.i = icmp sgt i64 %w4, 0
  br i1 %.87297.i, label %B10.endif.lr.ph.i, label %_ZN7msf_jax4host4meso7kernels5apartB3v57B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedE.exit

B10.endif.lr.ph.i:                                ; preds = %0
  %.233275.not.i = icmp slt i64 %w2, 1
  br i1 %.233275.not.i, label %B10.endif.preheader.i, label %B10.endif.us.preheader.i

B10.endif.us.preheader.i:                         ; preds = %B10.endif.lr.ph.i
  %xtraiter.i = and i64 %w2, 3
  %unroll_iter.i = and i64 %w2, 9223372036854775804
  %1 = add nsw i64 %w2, -1
  %scevgep23.i = getelementptr i8, ptr %w0, i64 24
  %2 = icmp samesign ult i64 %w2, 4
  %3 = icmp eq i64 %xtraiter.i, 0
  br label %B10.endif.us.i

B10.endif.preheader.i:                            ; preds = %B10.endif.lr.ph.i
  %4 = icmp eq i64 %w4, 1
  br i1 %4, label %B10.endif.epil.preheader.i, label %B10.endif.preheader.new.i

B10.endif.preheader.new.i:                        ; preds = %B10.endif.preheader.i
  %unroll_iter17.i = and i64 %w4, 9223372036854775806
  br label %B10.endif.i

B10.endif.us.i:                                   ; preds = %B204.us.i, %B10.endif.us.preheader.i
  %.86288298.us.i = phi i64 [ %.108.us363.i, %B204.us.i ], [ 0, %B10.endif.us.preheader.i ]
  %.99.us.i = shl i64 %.86288298.us.i, 3
  %.103.us.i = getelementptr i8, ptr %w3, i64 %.99.us.i
  %.105.us.i = load i64, ptr %.103.us.i, align 8
  %.308.us.i = icmp slt i64 %.105.us.i, 0
  %.309.us.i = select i1 %.308.us.i, i64 %w1, i64 0
  %.310.us.i = add i64 %.309.us.i, %.105.us.i
  %.330.us.i = mul i64 %.310.us.i, %w2
  %5 = getelementptr i64, ptr %w0, i64 %.330.us.i
  br label %B70.us.i

B204.us.loopexit.unr-lcssa.i:                     ; preds = %B174.us.i
  br i1 %3, label %B204.us.i, label %B174.us.epil.preheader.i

B174.us.epil.preheader.i:                         ; preds = %B174.us.preheader.i, %B204.us.loopexit.unr-lcssa.i
  %.506282284.us.epil.init.i = phi i64 [ %unroll_iter.i, %B204.us.loopexit.unr-lcssa.i ], [ 0, %B174.us.preheader.i ]
  %6 = shl i64 %.506282284.us.epil.init.i, 3
  %7 = getelementptr i8, ptr %w0, i64 %.pre.i
  %scevgep32.i = getelementptr i8, ptr %7, i64 %6
  br label %B174.us.epil.i

B174.us.epil.i:                                   ; preds = %B174.us.epil.i, %B174.us.epil.preheader.i
  %epil.iter.i = phi i64 [ %epil.iter.next.i, %B174.us.epil.i ], [ 0, %B174.us.epil.preheader.i ]
  %8 = shl nuw nsw i64 %epil.iter.i, 3
  %scevgep33.i = getelementptr i8, ptr %scevgep32.i, i64 %8
  %.588.us.epil.i = load i64, ptr %scevgep33.i, align 8
  %.602.us.epil.i = icmp slt i64 %.588.us.epil.i, 0
  %.603.us.epil.i = select i1 %.602.us.epil.i, i64 %w6, i64 0
  %9 = getelementptr i8, ptr %w5, i64 %.588.us.epil.i
  %.617.us.epil.i = getelementptr i8, ptr %9, i64 %.603.us.epil.i
  store i8 1, ptr %.617.us.epil.i, align 1
  %epil.iter.next.i = add i64 %epil.iter.i, 1
  %epil.iter.cmp.not.i = icmp eq i64 %xtraiter.i, %epil.iter.next.i
  br i1 %epil.iter.cmp.not.i, label %B204.us.i, label %B174.us.epil.i

B204.us.i:                                        ; preds = %B108.us.thread.i, %B174.us.epil.i, %B68.B112_crit_edge.us.i, %B204.us.loopexit.unr-lcssa.i
  %"$phi108.2.2.2.us359362.i" = phi i8 [ 1, %B204.us.loopexit.unr-lcssa.i ], [ 0, %B68.B112_crit_edge.us.i ], [ 1, %B174.us.epil.i ], [ 0, %B108.us.thread.i ]
  %.108.us363.i = add nuw nsw i64 %.86288298.us.i, 1
  %.641.us.i = select i1 %.308.us.i, i64 %w8, i64 0
  %10 = getelementptr i8, ptr %w7, i64 %.105.us.i
  %.655.us.i = getelementptr i8, ptr %10, i64 %.641.us.i
  store i8 %"$phi108.2.2.2.us359362.i", ptr %.655.us.i, align 1
  %exitcond355.not.i = icmp eq i64 %.108.us363.i, %w4
  br i1 %exitcond355.not.i, label %_ZN7msf_jax4host4meso7kernels5apartB3v57B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedE.exit, label %B10.endif.us.i

B174.us.i:                                        ; preds = %B174.us.preheader19.i, %B174.us.i
  %.506282284.us.i = phi i64 [ %.513.us.3.i, %B174.us.i ], [ 0, %B174.us.preheader19.i ]
  %11 = shl i64 %.506282284.us.i, 3
  %scevgep30.i = getelementptr i8, ptr %scevgep24.i, i64 %11
  %scevgep31.i = getelementptr i8, ptr %scevgep30.i, i64 -24
  %.588.us.i = load i64, ptr %scevgep31.i, align 8
  %.602.us.i = icmp slt i64 %.588.us.i, 0
  %.603.us.i = select i1 %.602.us.i, i64 %w6, i64 0
  %12 = getelementptr i8, ptr %w5, i64 %.588.us.i
  %.617.us.i = getelementptr i8, ptr %12, i64 %.603.us.i
  store i8 1, ptr %.617.us.i, align 1
  %scevgep29.i = getelementptr i8, ptr %scevgep30.i, i64 -16
  %.588.us.1.i = load i64, ptr %scevgep29.i, align 8
  %.602.us.1.i = icmp slt i64 %.588.us.1.i, 0
  %.603.us.1.i = select i1 %.602.us.1.i, i64 %w6, i64 0
  %13 = getelementptr i8, ptr %w5, i64 %.588.us.1.i
  %.617.us.1.i = getelementptr i8, ptr %13, i64 %.603.us.1.i
  store i8 1, ptr %.617.us.1.i, align 1
  %scevgep27.i = getelementptr i8, ptr %scevgep30.i, i64 -8
  %.588.us.2.i = load i64, ptr %scevgep27.i, align 8
  %.602.us.2.i = icmp slt i64 %.588.us.2.i, 0
  %.603.us.2.i = select i1 %.602.us.2.i, i64 %w6, i64 0
  %14 = getelementptr i8, ptr %w5, i64 %.588.us.2.i
  %.617.us.2.i = getelementptr i8, ptr %14, i64 %.603.us.2.i
  store i8 1, ptr %.617.us.2.i, align 1
  %.513.us.3.i = add nuw nsw i64 %.506282284.us.i, 4
  %.588.us.3.i = load i64, ptr %scevgep30.i, align 8
  %.602.us.3.i = icmp slt i64 %.588.us.3.i, 0
  %.603.us.3.i = select i1 %.602.us.3.i, i64 %w6, i64 0
  %15 = getelementptr i8, ptr %w5, i64 %.588.us.3.i
  %.617.us.3.i = getelementptr i8, ptr %15, i64 %.603.us.3.i
  store i8 1, ptr %.617.us.3.i, align 1
  %niter.ncmp.3.i = icmp eq i64 %unroll_iter.i, %.513.us.3.i
  br i1 %niter.ncmp.3.i, label %B204.us.loopexit.unr-lcssa.i, label %B174.us.i

B70.us.i:                                         ; preds = %B70.us.backedge.i, %B10.endif.us.i
  %is_free.2.1278.us.i = phi i1 [ true, %B10.endif.us.i ], [ %is_free.2.1278.us.be.i, %B70.us.backedge.i ]
  %.239274276.us.i = phi i64 [ 0, %B10.endif.us.i ], [ %.246.us.i, %B70.us.backedge.i ]
  br i1 %is_free.2.1278.us.i, label %B108.us.i, label %B108.us.thread.i

B108.us.i:                                        ; preds = %B70.us.i
  %16 = shl i64 %.239274276.us.i, 3
  %scevgep22.i = getelementptr i8, ptr %5, i64 %16
  %.335.us.i = load i64, ptr %scevgep22.i, align 8
  %.349.us.i = icmp slt i64 %.335.us.i, 0
  %.350.us.i = select i1 %.349.us.i, i64 %w6, i64 0
  %17 = getelementptr i8, ptr %w5, i64 %.335.us.i
  %.364.us.i = getelementptr i8, ptr %17, i64 %.350.us.i
  %.365.us.i = load i8, ptr %.364.us.i, align 1
  %.368.not.us.i = icmp eq i8 %.365.us.i, 0
  %exitcond.not.i = icmp eq i64 %1, %.239274276.us.i
  br i1 %exitcond.not.i, label %B68.B112_crit_edge.us.i, label %B70.us.backedge.i

B70.us.backedge.i:                                ; preds = %B108.us.thread.i, %B108.us.i
  %is_free.2.1278.us.be.i = phi i1 [ %.368.not.us.i, %B108.us.i ], [ false, %B108.us.thread.i ]
  %.246.us.i = add nuw nsw i64 %.239274276.us.i, 1
  br label %B70.us.i

B108.us.thread.i:                                 ; preds = %B70.us.i
  %exitcond.not358.i = icmp eq i64 %1, %.239274276.us.i
  br i1 %exitcond.not358.i, label %B204.us.i, label %B70.us.backedge.i

B68.B112_crit_edge.us.i:                          ; preds = %B108.us.i
  br i1 %.368.not.us.i, label %B174.us.preheader.i, label %B204.us.i

B174.us.preheader.i:                              ; preds = %B68.B112_crit_edge.us.i
  %.pre.i = mul i64 %.310.us.i, %s3
  br i1 %2, label %B174.us.epil.preheader.i, label %B174.us.preheader19.i

B174.us.preheader19.i:                            ; preds = %B174.us.preheader.i
  %scevgep24.i = getelementptr i8, ptr %scevgep23.i, i64 %.pre.i
  br label %B174.us.i

B216.loopexit.unr-lcssa.i:                        ; preds = %B10.endif.i
  %18 = and i64 %w4, 1
  %lcmp.mod15.not.i = icmp eq i64 %18, 0
  br i1 %lcmp.mod15.not.i, label %_ZN7msf_jax4host4meso7kernels5apartB3v57B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedE.exit, label %B10.endif.epil.preheader.i

B10.endif.epil.preheader.i:                       ; preds = %B216.loopexit.unr-lcssa.i, %B10.endif.preheader.i
  %.86288298.epil.init.i = phi i64 [ 0, %B10.endif.preheader.i ], [ %unroll_iter17.i, %B216.loopexit.unr-lcssa.i ]
  %.99.epil.i = shl i64 %.86288298.epil.init.i, 3
  %.103.epil.i = getelementptr i8, ptr %w3, i64 %.99.epil.i
  %.105.epil.i = load i64, ptr %.103.epil.i, align 8
  %.640.epil.i = icmp slt i64 %.105.epil.i, 0
  %.641.epil.i = select i1 %.640.epil.i, i64 %w8, i64 0
  %19 = getelementptr i8, ptr %w7, i64 %.105.epil.i
  %.655.epil.i = getelementptr i8, ptr %19, i64 %.641.epil.i
  store i8 1, ptr %.655.epil.i, align 1
  br label %_ZN7msf_jax4host4meso7kernels5apartB3v57B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedE.exit

B10.endif.i:                                      ; preds = %B10.endif.i, %B10.endif.preheader.new.i
  %lsr.iv.i = phi ptr [ %scevgep.i, %B10.endif.i ], [ %w3, %B10.endif.preheader.new.i ]
  %.86288298.i = phi i64 [ %.108.1.i, %B10.endif.i ], [ 0, %B10.endif.preheader.new.i ]
  %.105.i = load i64, ptr %lsr.iv.i, align 8
  %.640.i = icmp slt i64 %.105.i, 0
  %.641.i = select i1 %.640.i, i64 %w8, i64 0
  %20 = getelementptr i8, ptr %w7, i64 %.105.i
  %.655.i = getelementptr i8, ptr %20, i64 %.641.i
  store i8 1, ptr %.655.i, align 1
  %scevgep21.i = getelementptr i8, ptr %lsr.iv.i, i64 8
  %.105.1.i = load i64, ptr %scevgep21.i, align 8
  %.108.1.i = add nuw i64 %.86288298.i, 2
  %.640.1.i = icmp slt i64 %.105.1.i, 0
  %.641.1.i = select i1 %.640.1.i, i64 %w8, i64 0
  %21 = getelementptr i8, ptr %w7, i64 %.105.1.i
  %.655.1.i = getelementptr i8, ptr %21, i64 %.641.1.i
  store i8 1, ptr %.655.1.i, align 1
  %scevgep.i = getelementptr i8, ptr %lsr.iv.i, i64 16
  %niter18.ncmp.1.i = icmp eq i64 %unroll_iter17.i, %.108.1.i
  br i1 %niter18.ncmp.1.i, label %B216.loopexit.unr-lcssa.i, label %B10.endif.i

_ZN7msf_jax4host4meso7kernels5apartB3v57B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedE.exit: ; preds = %B204.us.i, %0, %B216.loopexit.unr-lcssa.i, %B10.endif.epil.preheader.i
  ret i64 0
}

define i64 @msf_jax.host.meso.kernels.collapse(ptr readonly %words) local_unnamed_addr {
  %w0 = load ptr, ptr %words, align 8
  %p1 = getelementptr i8, ptr %words, i64 8
  %w1 = load i64, ptr %p1, align 8
  %p2 = getelementptr i8, ptr %words, i64 16
  %w2 = load i64, ptr %p2, align 8
  %s3 = shl i64 %w2, 3
  %p3 = getelementptr i8, ptr %words, i64 24
  %w3 = load ptr, ptr %p3, align 8
  %p4 = getelementptr i8, ptr %words, i64 32
  %w4 = load i64, ptr %p4, align 8
  %p5 = getelementptr i8, ptr %words, i64 40
  %w5 = load i64, ptr %p5, align 8
  %s8 = shl i64 %w5, 3
  %p6 = getelementptr i8, ptr %words, i64 48
  %w6 = load ptr, ptr %p6, align 8
  %p7 = getelementptr i8, ptr %words, i64 56
  %w7 = load i64, ptr %p7, align 8
  %p8 = getelementptr i8, ptr %words, i64 64
  %w8 = load ptr, ptr %p8, align 8
  %p9 = getelementptr i8, ptr %words, i64 72
  %w9 = load i64, ptr %p9, align 8
  %p10 = getelementptr i8, ptr %words, i64 80
  %w10 = load i64, ptr %p10, align 8
  %s16 = shl i64 %w10, 3
  %p11 = getelementptr i8, ptr %words, i64 88
  %w11 = load ptr, ptr %p11, align 8
  %p12 = getelementptr i8, ptr %words, i64 96
  %w12 = load i64, ptr %p12, align 8
  %p13 = getelementptr i8, ptr %words, i64 104
  %w13 = load i64, ptr %p13, align 8
  %p14 = getelementptr i8, ptr %words, i64 112
  %w14 = load ptr, ptr %p14, align 8
  %p15 = getelementptr i8, ptr %words, i64 120
  %w15 = load i64, ptr %p15, align 8
  %p16 = getelementptr i8, ptr %words, i64 128
  %w16 = load ptr, ptr %p16, align 8
  %p17 = getelementptr i8, ptr %words, i64 136
  %w17 = load i64, ptr %p17, align 8
  %p18 = getelementptr i8, ptr %words, i64 144
  %w18 = load ptr, ptr %p18, align 8
  %p19 = getelementptr i8, ptr %words, i64 152
  %w19 = load i64, ptr %p19, align 8
  %p20 = getelementptr i8, ptr %words, i64 160
  %w20 = load ptr, ptr %p20, align 8
  %p21 = getelementptr i8, ptr %words, i64 168
  %w21 = load i64, ptr %p21, align 8
  %p22 = getelementptr i8, ptr %words, i64 176
  %w22 = load ptr, ptr %p22, align 8
  %p23 = getelementptr i8, ptr %words, i64 184
  %w23 = load i64, ptr %p23, align 8
  %p24 = getelementptr i8, ptr %words, i64 192
  %w24 = load i64, ptr %p24, align 8
  %p25 = getelementptr i8, ptr %words, i64 200
  %w25 = load ptr, ptr %p25, align 8
  %p26 = getelementptr i8, ptr %words, i64 208
  %w26 = load i64, ptr %p26, align 8
  %p27 = getelementptr i8, ptr %words, i64 216
  %w27 = load ptr, ptr %p27, align 8
  %p28 = getelementptr i8, ptr %words, i64 224
  %w28 = load i64, ptr %p28, align 8
  %p29 = getelementptr i8, ptr %words, i64 232
  %w29 = load i64, ptr %p29, align 8
  %p31 = getelementptr i8, ptr %words, i64 248
  %w31 = load ptr, ptr %p31, align 8
  %p32 = getelementptr i8, ptr %words, i64 256
  %w32 = load i64, ptr %p32, align 8
  %p33 = getelementptr i8, ptr %words, i64 264
  %w33 = load ptr, ptr %p33, align 8
  %p34 = getelementptr i8, ptr %words, i64 272
  %w34 = load i64, ptr %p34, align 8
  %p35 = getelementptr i8, ptr %words, i64 280
  %w35 = load ptr, ptr %p35, align 8
  %p38 = getelementptr i8, ptr %words, i64 304
  %w38 = load ptr, ptr %p38, align 8
  %p39 = getelementptr i8, ptr %words, i64 312
  %w39 = load i64, ptr %p39, align 8
  %p40 = getelementptr i8, ptr %words, i64 320
  %w40 = load i64, ptr %p40, align 8
  %p41 = getelementptr i8, ptr %words, i64 328
  %w41 = load ptr, ptr %p41, align 8
  %p42 = getelementptr i8, ptr %words, i64 336
  %w42 = load i64, ptr %p42, align 8
  %.2711082.i = icmp sgt i64 %w26, 0
  br i1 %.2711082.i, label %B58.preheader.i, label %_ZN7msf_jax4host4meso7kernels8collapseB3v58B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE385Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28bool_2c_201d_2c_20C_29_2c_20array_28bool_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEb5ArrayIbLi1E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B58.preheader.i:                                  ; preds = %0
  %p37 = getelementptr i8, ptr %words, i64 296
  %w37 = load i64, ptr %p37, align 8
  %s58 = shl i64 %w37, 3
  %p30 = getelementptr i8, ptr %words, i64 240
  %w30 = load i8, ptr %p30, align 8
  %unroll_iter.i224.i = and i64 %w24, 9223372036854775806
  %invariant.gep.i = getelementptr double, ptr %w22, i64 %unroll_iter.i224.i
  %1 = add nsw i64 %unroll_iter.i224.i, -2
  %2 = lshr exact i64 %1, 1
  %3 = add nuw i64 %2, 1
  %unroll_iter.i = and i64 %3, -2
  %scevgep296.i = getelementptr i8, ptr %w22, i64 24
  %4 = icmp eq i8 %w30, 0
  %.564.i.i = icmp sgt i64 %w5, 0
  %5 = getelementptr i64, ptr %w35, i64 %w37
  %6 = add i64 %s8, 8
  %7 = add i64 %s16, 8
  %8 = add i64 %s8, 16
  %9 = add i64 %s16, 16
  %.22781011.not.i.i = icmp slt i64 %w5, 1
  %10 = icmp eq i64 %w5, 1
  %unroll_iter.i7.i = and i64 %w5, 9223372036854775806
  %11 = getelementptr i8, ptr %w35, i64 %s58
  %scevgep51.i.i = getelementptr i8, ptr %11, i64 8
  %12 = and i64 %w5, 1
  %lcmp.mod38.not.i.i = icmp eq i64 %12, 0
  %13 = icmp slt i64 %w24, 1
  %14 = icmp eq i64 %w24, 1
  %15 = icmp eq i64 %1, 0
  %16 = and i64 %1, 2
  %.not.i = icmp eq i64 %16, 0
  %17 = and i64 %w24, 1
  %18 = icmp eq i64 %17, 0
  %.2368.epil.i.i = getelementptr i64, ptr %w35, i64 %unroll_iter.i7.i
  %.2524.epil.i.i = getelementptr i64, ptr %5, i64 %unroll_iter.i7.i
  br label %B58.i

B58.i:                                            ; preds = %B733.i, %B58.preheader.i
  %count.2.01084.i = phi i64 [ %count.3.1.i, %B733.i ], [ 0, %B58.preheader.i ]
  %.27010741083.i = phi i64 [ %.292.i, %B733.i ], [ 0, %B58.preheader.i ]
  %.283.i = shl i64 %.27010741083.i, 3
  %.287.i = getelementptr i8, ptr %w25, i64 %.283.i
  %.289.i = load i64, ptr %.287.i, align 8
  %.292.i = add nuw nsw i64 %.27010741083.i, 1
  %.347.i = icmp slt i64 %.289.i, 0
  %.348.i = select i1 %.347.i, i64 %w28, i64 0
  %.349.i = add i64 %.348.i, %.289.i
  %.369.i = mul i64 %.349.i, %w29
  %.373.i = getelementptr i64, ptr %w27, i64 %.369.i
  %.374.i = load i64, ptr %.373.i, align 8
  %.428.i = getelementptr i8, ptr %.373.i, i64 8
  %.429.i = load i64, ptr %.428.i, align 8
  %.483.i = getelementptr i8, ptr %.373.i, i64 16
  %.484.i = load i64, ptr %.483.i, align 8
  %.538.i = getelementptr i8, ptr %.373.i, i64 24
  %.539.i = load i64, ptr %.538.i, align 8
  %.613.i = getelementptr i8, ptr %.373.i, i64 32
  %.614.i = load i64, ptr %.613.i, align 8
  %.615.not.i = icmp eq i64 %.614.i, 2
  br i1 %.615.not.i, label %B174.i, label %B270.i

B174.i:                                           ; preds = %B58.i
  %.631.i = icmp slt i64 %.374.i, 0
  %.632.i = select i1 %.631.i, i64 %w17, i64 0
  %19 = getelementptr i8, ptr %w16, i64 %.374.i
  %.646.i = getelementptr i8, ptr %19, i64 %.632.i
  %.647.i = load i8, ptr %.646.i, align 1
  %.650.i = icmp eq i8 %.647.i, 0
  br i1 %.650.i, label %B206.endif.i, label %B190.i

B190.i:                                           ; preds = %B174.i
  %.672.i = icmp slt i64 %.429.i, 0
  %.673.i = select i1 %.672.i, i64 %w17, i64 0
  %20 = getelementptr i8, ptr %w16, i64 %.429.i
  %.687.i = getelementptr i8, ptr %20, i64 %.673.i
  %.688.i = load i8, ptr %.687.i, align 1
  %.691.i = icmp eq i8 %.688.i, 0
  br i1 %.691.i, label %B206.endif.i, label %B270.i

B270.i:                                           ; preds = %B206.endif.i, %B190.i, %B58.i
  %sunkaddr.i = shl i64 %.369.i, 3
  %sunkaddr315.i = getelementptr i8, ptr %w27, i64 %sunkaddr.i
  store i64 -1, ptr %sunkaddr315.i, align 8
  br label %B733.i

B286.i:                                           ; preds = %B206.endif.i
  %.884.i = select i1 %.631.i, i64 %w32, i64 0
  %21 = getelementptr i8, ptr %w31, i64 %.374.i
  %.898.i = getelementptr i8, ptr %21, i64 %.884.i
  %.899.i = load i8, ptr %.898.i, align 1
  %.902.i = icmp eq i8 %.899.i, 0
  br i1 %.902.i, label %B302.i, label %B733.i

B302.i:                                           ; preds = %B286.i
  %.924.i = icmp slt i64 %.429.i, 0
  %.925.i = select i1 %.924.i, i64 %w32, i64 0
  %22 = getelementptr i8, ptr %w31, i64 %.429.i
  %.939.i = getelementptr i8, ptr %22, i64 %.925.i
  %.940.i = load i8, ptr %.939.i, align 1
  %.943.i = icmp eq i8 %.940.i, 0
  br i1 %.943.i, label %B320.i, label %B733.i

B320.i:                                           ; preds = %B302.i
  store i8 1, ptr %.898.i, align 1
  %.88.i.i = select i1 %.631.i, i64 %w7, i64 0
  %23 = getelementptr i64, ptr %w6, i64 %.374.i
  %.102.i.i = getelementptr i64, ptr %23, i64 %.88.i.i
  %.103.i.i = load i64, ptr %.102.i.i, align 8
  %.185113.not.i.i = icmp slt i64 %.103.i.i, 1
  br i1 %.185113.not.i.i, label %B320.endif.i, label %B58.lr.ph.i.i

B58.lr.ph.i.i:                                    ; preds = %B320.i
  %.247.i.i = select i1 %.631.i, i64 %w4, i64 0
  %.248.i.i = add i64 %.247.i.i, %.374.i
  %xtraiter.i.i = and i64 %.103.i.i, 3
  %24 = icmp samesign ult i64 %.103.i.i, 4
  br i1 %24, label %B58.epil.preheader.i.i, label %B58.lr.ph.new.i.i

B58.lr.ph.new.i.i:                                ; preds = %B58.lr.ph.i.i
  %unroll_iter.i.i = and i64 %.103.i.i, 9223372036854775804
  %25 = mul i64 %.248.i.i, %s8
  %26 = getelementptr i8, ptr %w3, i64 %25
  %scevgep3.i.i = getelementptr i8, ptr %26, i64 24
  br label %B58.i.i

B58.i.i:                                          ; preds = %B58.i.i, %B58.lr.ph.new.i.i
  %.191112114.i.i = phi i64 [ 0, %B58.lr.ph.new.i.i ], [ %.198.3.i.i, %B58.i.i ]
  %27 = shl i64 %.191112114.i.i, 3
  %scevgep9.i.i = getelementptr i8, ptr %scevgep3.i.i, i64 %27
  %scevgep10.i.i = getelementptr i8, ptr %scevgep9.i.i, i64 -24
  %.273.i.i = load i64, ptr %scevgep10.i.i, align 8
  %.287.i.i = icmp slt i64 %.273.i.i, 0
  %.288.i.i = select i1 %.287.i.i, i64 %w32, i64 0
  %28 = getelementptr i8, ptr %w31, i64 %.273.i.i
  %.302.i.i = getelementptr i8, ptr %28, i64 %.288.i.i
  store i8 1, ptr %.302.i.i, align 1
  %scevgep289.i = getelementptr i8, ptr %scevgep9.i.i, i64 -16
  %.273.1.i.i = load i64, ptr %scevgep289.i, align 8
  %.287.1.i.i = icmp slt i64 %.273.1.i.i, 0
  %.288.1.i.i = select i1 %.287.1.i.i, i64 %w32, i64 0
  %29 = getelementptr i8, ptr %w31, i64 %.273.1.i.i
  %.302.1.i.i = getelementptr i8, ptr %29, i64 %.288.1.i.i
  store i8 1, ptr %.302.1.i.i, align 1
  %scevgep287.i = getelementptr i8, ptr %scevgep9.i.i, i64 -8
  %.273.2.i.i = load i64, ptr %scevgep287.i, align 8
  %.287.2.i.i = icmp slt i64 %.273.2.i.i, 0
  %.288.2.i.i = select i1 %.287.2.i.i, i64 %w32, i64 0
  %30 = getelementptr i8, ptr %w31, i64 %.273.2.i.i
  %.302.2.i.i = getelementptr i8, ptr %30, i64 %.288.2.i.i
  store i8 1, ptr %.302.2.i.i, align 1
  %.198.3.i.i = add nuw nsw i64 %.191112114.i.i, 4
  %.273.3.i.i = load i64, ptr %scevgep9.i.i, align 8
  %.287.3.i.i = icmp slt i64 %.273.3.i.i, 0
  %.288.3.i.i = select i1 %.287.3.i.i, i64 %w32, i64 0
  %31 = getelementptr i8, ptr %w31, i64 %.273.3.i.i
  %.302.3.i.i = getelementptr i8, ptr %31, i64 %.288.3.i.i
  store i8 1, ptr %.302.3.i.i, align 1
  %niter.ncmp.3.i.i = icmp eq i64 %unroll_iter.i.i, %.198.3.i.i
  br i1 %niter.ncmp.3.i.i, label %B88.loopexit.unr-lcssa.i.i, label %B58.i.i

B88.loopexit.unr-lcssa.i.i:                       ; preds = %B58.i.i
  %lcmp.mod.not.i.i = icmp eq i64 %xtraiter.i.i, 0
  br i1 %lcmp.mod.not.i.i, label %B320.endif.i, label %B58.epil.preheader.i.i

B58.epil.preheader.i.i:                           ; preds = %B88.loopexit.unr-lcssa.i.i, %B58.lr.ph.i.i
  %.191112114.epil.init.i.i = phi i64 [ 0, %B58.lr.ph.i.i ], [ %unroll_iter.i.i, %B88.loopexit.unr-lcssa.i.i ]
  %32 = mul i64 %.248.i.i, %w5
  %33 = add i64 %.191112114.epil.init.i.i, %32
  %34 = shl i64 %33, 3
  %scevgep.i.i = getelementptr i8, ptr %w3, i64 %34
  br label %B58.epil.i.i

B58.epil.i.i:                                     ; preds = %B58.epil.i.i, %B58.epil.preheader.i.i
  %epil.iter.i.i = phi i64 [ 0, %B58.epil.preheader.i.i ], [ %epil.iter.next.i.i, %B58.epil.i.i ]
  %35 = shl i64 %epil.iter.i.i, 3
  %scevgep290.i = getelementptr i8, ptr %scevgep.i.i, i64 %35
  %.273.epil.i.i = load i64, ptr %scevgep290.i, align 8
  %.287.epil.i.i = icmp slt i64 %.273.epil.i.i, 0
  %.288.epil.i.i = select i1 %.287.epil.i.i, i64 %w32, i64 0
  %36 = getelementptr i8, ptr %w31, i64 %.273.epil.i.i
  %.302.epil.i.i = getelementptr i8, ptr %36, i64 %.288.epil.i.i
  store i8 1, ptr %.302.epil.i.i, align 1
  %epil.iter.next.i.i = add i64 %epil.iter.i.i, 1
  %epil.iter.cmp.not.i.i = icmp eq i64 %xtraiter.i.i, %epil.iter.next.i.i
  br i1 %epil.iter.cmp.not.i.i, label %B320.endif.i, label %B58.epil.i.i

B444.i:                                           ; preds = %B320.endif.endif.i
  %.143.i.i = select i1 %.1115.i, i64 %w7, i64 0
  %37 = getelementptr i64, ptr %w6, i64 %one.2.2.i
  %.157.i.i = getelementptr i64, ptr %37, i64 %.143.i.i
  %.158.i.i = load i64, ptr %.157.i.i, align 8
  %.251496.not.i.i = icmp slt i64 %.158.i.i, 1
  br i1 %.251496.not.i.i, label %B482.i, label %B92.lr.ph.i.i

B92.lr.ph.i.i:                                    ; preds = %B444.i
  %.313.i.i = select i1 %.1115.i, i64 %w4, i64 0
  %.314.i.i = add i64 %.313.i.i, %one.2.2.i
  %.334.i.i = mul i64 %.314.i.i, %w5
  %38 = getelementptr i64, ptr %w3, i64 %.334.i.i
  %.932.i.i = select i1 %.1115.i, i64 %w1, i64 0
  %.933.i.i = add i64 %.932.i.i, %one.2.2.i
  %.1103.i.i = icmp slt i64 %two.2.2.i, 0
  %.1104.i.i = select i1 %.1103.i.i, i64 %w1, i64 0
  %.1105.i.i = add i64 %.1104.i.i, %two.2.2.i
  %.953.reass.i.i = mul i64 %.933.i.i, %s3
  %.1125.reass.i.i = mul i64 %.1105.i.i, %s3
  %sunkaddr317.i = getelementptr i8, ptr %w0, i64 %.953.reass.i.i
  %sunkaddr318.i = getelementptr i8, ptr %sunkaddr317.i, i64 8
  %sunkaddr320.i = getelementptr i8, ptr %sunkaddr317.i, i64 16
  %sunkaddr322.i = getelementptr i8, ptr %w0, i64 %.1125.reass.i.i
  %sunkaddr323.i = getelementptr i8, ptr %sunkaddr322.i, i64 8
  %sunkaddr325.i = getelementptr i8, ptr %sunkaddr322.i, i64 16
  br label %B92.endif.i.i

B158.i.i:                                         ; preds = %B92.endif.i.i
  %.84.i.i.i = icmp ne i64 %one.2.2.i, %.432.i.i
  %.84.1.i.i.i = icmp ne i64 %two.2.2.i, %.432.i.i
  %or.cond.i.not.i.i = select i1 %.84.i.i.i, i1 %.84.1.i.i.i, i1 false
  br i1 %or.cond.i.not.i.i, label %B632.i.i, label %B705.i.i

B632.i.i:                                         ; preds = %B158.i.i
  %.727.i.i = icmp slt i64 %.339.i.i, 0
  %.728.i.i = select i1 %.727.i.i, i64 %w1, i64 0
  %.729.i.i = add i64 %.728.i.i, %.339.i.i
  %.749.i.i = mul i64 %.729.i.i, %w2
  %39 = getelementptr double, ptr %w0, i64 %.749.i.i
  %.829.i.i = icmp slt i64 %.432.i.i, 0
  %.830.i.i = select i1 %.829.i.i, i64 %w1, i64 0
  %.831.i.i = add i64 %.830.i.i, %.432.i.i
  %.851.i.i = mul i64 %.831.i.i, %w2
  %40 = getelementptr double, ptr %w0, i64 %.851.i.i
  %.753.i.i = getelementptr i8, ptr %39, i64 8
  %.754.i.i = load double, ptr %.753.i.i, align 8
  %.804.i.i = getelementptr i8, ptr %39, i64 16
  %.805.i.i = load double, ptr %.804.i.i, align 8
  %.855.i.i = getelementptr i8, ptr %40, i64 8
  %.856.i.i = load double, ptr %.855.i.i, align 8
  %.906.i.i = getelementptr i8, ptr %40, i64 16
  %.907.i.i = load double, ptr %.906.i.i, align 8
  %.958.i.i = load double, ptr %sunkaddr318.i, align 8
  %.1009.i.i = load double, ptr %sunkaddr320.i, align 8
  %.1022.i.i = fsub double %.754.i.i, %.958.i.i
  %.1023.i.i = fsub double %.907.i.i, %.1009.i.i
  %.1024.i.i = fmul double %.1022.i.i, %.1023.i.i
  %.1025.i.i = fsub double %.805.i.i, %.1009.i.i
  %.1026.i.i = fsub double %.856.i.i, %.958.i.i
  %.1027.i.i = fmul double %.1026.i.i, %.1025.i.i
  %.1028.i.i = fsub double %.1024.i.i, %.1027.i.i
  %.1353.i.i = fmul double %.1028.i.i, %.1028.i.i
  %.754.1.i.i = load double, ptr %39, align 8
  %.856.1.i.i = load double, ptr %40, align 8
  %.958.1.i.i = load double, ptr %sunkaddr317.i, align 8
  %.1022.1.i.i = fsub double %.754.1.i.i, %.958.1.i.i
  %.1024.1.i.i = fmul double %.1026.i.i, %.1022.1.i.i
  %.1026.1.i.i = fsub double %.856.1.i.i, %.958.1.i.i
  %.1027.1.i.i = fmul double %.1022.i.i, %.1026.1.i.i
  %.1028.1.i.i = fsub double %.1024.1.i.i, %.1027.1.i.i
  %.1353.1.i.i = fmul double %.1028.1.i.i, %.1028.1.i.i
  %.1355.1.i.i = fadd double %.1353.i.i, %.1353.1.i.i
  %.1024.2.i.i = fmul double %.1025.i.i, %.1026.1.i.i
  %.1027.2.i.i = fmul double %.1023.i.i, %.1022.1.i.i
  %.1028.2.i.i = fsub double %.1024.2.i.i, %.1027.2.i.i
  %.1353.2.i.i = fmul double %.1028.2.i.i, %.1028.2.i.i
  %.1355.2.i.i = fadd double %.1353.2.i.i, %.1355.1.i.i
  %.1376.i.i = fcmp ogt double %.1355.2.i.i, 0.000000e+00
  br i1 %.1376.i.i, label %B644.i.i, label %B705.i.i

B644.i.i:                                         ; preds = %B632.i.i
  %.1130.i.i = load double, ptr %sunkaddr323.i, align 8
  %.1182.i.i = fsub double %.1130.i.i, %.958.i.i
  %.1184.i.i = fmul double %"$phi438.1.2.2.i", %.1182.i.i
  %.1185.i.i = fadd double %.958.i.i, %.1184.i.i
  %.1343.i.i = fsub double %.754.i.i, %.1185.i.i
  %.1287.i.i = load double, ptr %sunkaddr325.i, align 8
  %.1339.i.i = fsub double %.1287.i.i, %.1009.i.i
  %.1341.i.i = fmul double %"$phi438.1.2.2.i", %.1339.i.i
  %.1342.i.i = fadd double %.1009.i.i, %.1341.i.i
  %.1344.i.i = fsub double %.907.i.i, %.1342.i.i
  %.1345.i.i = fmul double %.1343.i.i, %.1344.i.i
  %.1347.i.i = fsub double %.856.i.i, %.1185.i.i
  %.1346.i.i = fsub double %.805.i.i, %.1342.i.i
  %.1348.i.i = fmul double %.1347.i.i, %.1346.i.i
  %.1349.i.i = fsub double %.1345.i.i, %.1348.i.i
  %.1356.i.i = fmul double %.1349.i.i, %.1349.i.i
  %.1130.1.i.i = load double, ptr %sunkaddr322.i, align 8
  %.1182.1.i.i = fsub double %.1130.1.i.i, %.958.1.i.i
  %.1184.1.i.i = fmul double %"$phi438.1.2.2.i", %.1182.1.i.i
  %.1185.1.i.i = fadd double %.958.1.i.i, %.1184.1.i.i
  %.1343.1.i.i = fsub double %.754.1.i.i, %.1185.1.i.i
  %.1345.1.i.i = fmul double %.1347.i.i, %.1343.1.i.i
  %.1347.1.i.i = fsub double %.856.1.i.i, %.1185.1.i.i
  %.1348.1.i.i = fmul double %.1343.i.i, %.1347.1.i.i
  %.1349.1.i.i = fsub double %.1345.1.i.i, %.1348.1.i.i
  %.1356.1.i.i = fmul double %.1349.1.i.i, %.1349.1.i.i
  %.1358.1.i.i = fadd double %.1356.i.i, %.1356.1.i.i
  %.1345.2.i.i = fmul double %.1346.i.i, %.1347.1.i.i
  %.1348.2.i.i = fmul double %.1344.i.i, %.1343.1.i.i
  %.1349.2.i.i = fsub double %.1345.2.i.i, %.1348.2.i.i
  %.1356.2.i.i = fmul double %.1349.2.i.i, %.1349.2.i.i
  %.1358.2.i.i = fadd double %.1356.2.i.i, %.1358.1.i.i
  %.1350.i.i = fmul double %.1028.i.i, %.1349.i.i
  %.1352.i.i = fadd double %.1350.i.i, 0.000000e+00
  %.1350.1.i.i = fmul double %.1028.1.i.i, %.1349.1.i.i
  %.1352.1.i.i = fadd double %.1352.i.i, %.1350.1.i.i
  %.1350.2.i.i = fmul double %.1028.2.i.i, %.1349.2.i.i
  %.1352.2.i.i = fadd double %.1350.2.i.i, %.1352.1.i.i
  %.1380.i.i = fmul double %.1355.2.i.i, %.1358.2.i.i
  %sqrt.i.i = tail call double @llvm.sqrt.f64(double %.1380.i.i)
  %.1386.i.i = fmul double %sqrt.i.i, 5.000000e-01
  %.1388.i.i = fcmp ole double %.1352.2.i.i, %.1386.i.i
  %brmerge.i.i = or i1 %42, %.1388.i.i
  br i1 %brmerge.i.i, label %B444.endif.endif.i, label %B92.endif.backedge.i.i

B705.i.i:                                         ; preds = %B92.endif.i.i, %B632.i.i, %B158.i.i
  br i1 %42, label %B482.i, label %B92.endif.backedge.i.i

B92.endif.backedge.i.i:                           ; preds = %B705.i.i, %B644.i.i
  %lsr.iv.next.i.i = add nuw i64 %lsr.iv.i.i, 1
  br label %B92.endif.i.i

B92.endif.i.i:                                    ; preds = %B92.endif.backedge.i.i, %B92.lr.ph.i.i
  %lsr.iv.i.i = phi i64 [ %lsr.iv.next.i.i, %B92.endif.backedge.i.i ], [ 1, %B92.lr.ph.i.i ]
  %41 = shl i64 %lsr.iv.i.i, 3
  %scevgep.i24.i = getelementptr i8, ptr %38, i64 %41
  %scevgep18.i.i = getelementptr i8, ptr %scevgep.i24.i, i64 -8
  %.339.i.i = load i64, ptr %scevgep18.i.i, align 8
  %42 = icmp eq i64 %.158.i.i, %lsr.iv.i.i
  %iv.rem.i.i = select i1 %42, i64 0, i64 %lsr.iv.i.i
  %43 = getelementptr i64, ptr %38, i64 %iv.rem.i.i
  %.432.i.i = load i64, ptr %43, align 8
  %.84.i12.i.i = icmp ne i64 %one.2.2.i, %.339.i.i
  %.84.1.i13.i.i = icmp ne i64 %two.2.2.i, %.339.i.i
  %or.cond.i14.not.i.i = select i1 %.84.i12.i.i, i1 %.84.1.i13.i.i, i1 false
  br i1 %or.cond.i14.not.i.i, label %B158.i.i, label %B705.i.i

B482.i:                                           ; preds = %B705.i.i, %B444.endif.endif.i, %B444.i
  %.142.i25.i = icmp slt i64 %two.2.2.i, 0
  %.143.i26.i = select i1 %.142.i25.i, i64 %w7, i64 0
  %44 = getelementptr i64, ptr %w6, i64 %two.2.2.i
  %.157.i27.i = getelementptr i64, ptr %44, i64 %.143.i26.i
  %.158.i28.i = load i64, ptr %.157.i27.i, align 8
  %.251496.not.i29.i = icmp slt i64 %.158.i28.i, 1
  br i1 %.251496.not.i29.i, label %B536.i, label %B92.lr.ph.i30.i

B92.lr.ph.i30.i:                                  ; preds = %B482.i
  %.313.i31.i = select i1 %.142.i25.i, i64 %w4, i64 0
  %.314.i32.i = add i64 %.313.i31.i, %two.2.2.i
  %.334.i33.i = mul i64 %.314.i32.i, %w5
  %45 = getelementptr i64, ptr %w3, i64 %.334.i33.i
  %.932.i34.i = select i1 %.142.i25.i, i64 %w1, i64 0
  %.933.i35.i = add i64 %.932.i34.i, %two.2.2.i
  %.1053.i37.i = select i1 %.1115.i, i64 %w1, i64 0
  %.1054.i38.i = add i64 %.1053.i37.i, %one.2.2.i
  %.953.reass.i45.i = mul i64 %.933.i35.i, %s3
  %.1074.reass.i49.i = mul i64 %.1054.i38.i, %s3
  %sunkaddr327.i = getelementptr i8, ptr %w0, i64 %.953.reass.i45.i
  %sunkaddr328.i = getelementptr i8, ptr %sunkaddr327.i, i64 8
  %sunkaddr330.i = getelementptr i8, ptr %sunkaddr327.i, i64 16
  %sunkaddr332.i = getelementptr i8, ptr %w0, i64 %.1074.reass.i49.i
  %sunkaddr333.i = getelementptr i8, ptr %sunkaddr332.i, i64 8
  %sunkaddr335.i = getelementptr i8, ptr %sunkaddr332.i, i64 16
  br label %B92.endif.i57.i

B158.i71.i:                                       ; preds = %B92.endif.i57.i
  %.84.i.i72.i = icmp ne i64 %one.2.2.i, %.432.i63.i
  %.84.1.i.i73.i = icmp ne i64 %two.2.2.i, %.432.i63.i
  %or.cond.i.not.i74.i = select i1 %.84.i.i72.i, i1 %.84.1.i.i73.i, i1 false
  br i1 %or.cond.i.not.i74.i, label %B632.i75.i, label %B705.i67.i

B632.i75.i:                                       ; preds = %B158.i71.i
  %.727.i76.i = icmp slt i64 %.339.i61.i, 0
  %.728.i77.i = select i1 %.727.i76.i, i64 %w1, i64 0
  %.729.i78.i = add i64 %.728.i77.i, %.339.i61.i
  %.749.i79.i = mul i64 %.729.i78.i, %w2
  %46 = getelementptr double, ptr %w0, i64 %.749.i79.i
  %.829.i80.i = icmp slt i64 %.432.i63.i, 0
  %.830.i81.i = select i1 %.829.i80.i, i64 %w1, i64 0
  %.831.i82.i = add i64 %.830.i81.i, %.432.i63.i
  %.851.i83.i = mul i64 %.831.i82.i, %w2
  %47 = getelementptr double, ptr %w0, i64 %.851.i83.i
  %.753.i84.i = getelementptr i8, ptr %46, i64 8
  %.754.i85.i = load double, ptr %.753.i84.i, align 8
  %.804.i86.i = getelementptr i8, ptr %46, i64 16
  %.805.i87.i = load double, ptr %.804.i86.i, align 8
  %.855.i88.i = getelementptr i8, ptr %47, i64 8
  %.856.i89.i = load double, ptr %.855.i88.i, align 8
  %.906.i90.i = getelementptr i8, ptr %47, i64 16
  %.907.i91.i = load double, ptr %.906.i90.i, align 8
  %.958.i92.i = load double, ptr %sunkaddr328.i, align 8
  %.1009.i93.i = load double, ptr %sunkaddr330.i, align 8
  %.1022.i94.i = fsub double %.754.i85.i, %.958.i92.i
  %.1023.i95.i = fsub double %.907.i91.i, %.1009.i93.i
  %.1024.i96.i = fmul double %.1022.i94.i, %.1023.i95.i
  %.1025.i97.i = fsub double %.805.i87.i, %.1009.i93.i
  %.1026.i98.i = fsub double %.856.i89.i, %.958.i92.i
  %.1027.i99.i = fmul double %.1026.i98.i, %.1025.i97.i
  %.1028.i100.i = fsub double %.1024.i96.i, %.1027.i99.i
  %.1353.i101.i = fmul double %.1028.i100.i, %.1028.i100.i
  %.754.1.i102.i = load double, ptr %46, align 8
  %.856.1.i103.i = load double, ptr %47, align 8
  %.958.1.i104.i = load double, ptr %sunkaddr327.i, align 8
  %.1022.1.i105.i = fsub double %.754.1.i102.i, %.958.1.i104.i
  %.1024.1.i106.i = fmul double %.1026.i98.i, %.1022.1.i105.i
  %.1026.1.i107.i = fsub double %.856.1.i103.i, %.958.1.i104.i
  %.1027.1.i108.i = fmul double %.1022.i94.i, %.1026.1.i107.i
  %.1028.1.i109.i = fsub double %.1024.1.i106.i, %.1027.1.i108.i
  %.1353.1.i110.i = fmul double %.1028.1.i109.i, %.1028.1.i109.i
  %.1355.1.i111.i = fadd double %.1353.i101.i, %.1353.1.i110.i
  %.1024.2.i112.i = fmul double %.1025.i97.i, %.1026.1.i107.i
  %.1027.2.i113.i = fmul double %.1023.i95.i, %.1022.1.i105.i
  %.1028.2.i114.i = fsub double %.1024.2.i112.i, %.1027.2.i113.i
  %.1353.2.i115.i = fmul double %.1028.2.i114.i, %.1028.2.i114.i
  %.1355.2.i116.i = fadd double %.1353.2.i115.i, %.1355.1.i111.i
  %.1376.i117.i = fcmp ogt double %.1355.2.i116.i, 0.000000e+00
  br i1 %.1376.i117.i, label %B644.i118.i, label %B705.i67.i

B644.i118.i:                                      ; preds = %B632.i75.i
  %.1079.i119.i = load double, ptr %sunkaddr333.i, align 8
  %.1182.i121.i = fsub double %.958.i92.i, %.1079.i119.i
  %.1184.i122.i = fmul double %"$phi438.1.2.2.i", %.1182.i121.i
  %.1185.i123.i = fadd double %.1079.i119.i, %.1184.i122.i
  %.1343.i124.i = fsub double %.754.i85.i, %.1185.i123.i
  %.1236.i125.i = load double, ptr %sunkaddr335.i, align 8
  %.1339.i127.i = fsub double %.1009.i93.i, %.1236.i125.i
  %.1341.i128.i = fmul double %"$phi438.1.2.2.i", %.1339.i127.i
  %.1342.i129.i = fadd double %.1236.i125.i, %.1341.i128.i
  %.1344.i130.i = fsub double %.907.i91.i, %.1342.i129.i
  %.1345.i131.i = fmul double %.1343.i124.i, %.1344.i130.i
  %.1347.i132.i = fsub double %.856.i89.i, %.1185.i123.i
  %.1346.i133.i = fsub double %.805.i87.i, %.1342.i129.i
  %.1348.i134.i = fmul double %.1347.i132.i, %.1346.i133.i
  %.1349.i135.i = fsub double %.1345.i131.i, %.1348.i134.i
  %.1356.i136.i = fmul double %.1349.i135.i, %.1349.i135.i
  %.1079.1.i137.i = load double, ptr %sunkaddr332.i, align 8
  %.1182.1.i139.i = fsub double %.958.1.i104.i, %.1079.1.i137.i
  %.1184.1.i140.i = fmul double %"$phi438.1.2.2.i", %.1182.1.i139.i
  %.1185.1.i141.i = fadd double %.1079.1.i137.i, %.1184.1.i140.i
  %.1343.1.i142.i = fsub double %.754.1.i102.i, %.1185.1.i141.i
  %.1345.1.i143.i = fmul double %.1347.i132.i, %.1343.1.i142.i
  %.1347.1.i144.i = fsub double %.856.1.i103.i, %.1185.1.i141.i
  %.1348.1.i145.i = fmul double %.1343.i124.i, %.1347.1.i144.i
  %.1349.1.i146.i = fsub double %.1345.1.i143.i, %.1348.1.i145.i
  %.1356.1.i147.i = fmul double %.1349.1.i146.i, %.1349.1.i146.i
  %.1358.1.i148.i = fadd double %.1356.i136.i, %.1356.1.i147.i
  %.1345.2.i149.i = fmul double %.1346.i133.i, %.1347.1.i144.i
  %.1348.2.i150.i = fmul double %.1344.i130.i, %.1343.1.i142.i
  %.1349.2.i151.i = fsub double %.1345.2.i149.i, %.1348.2.i150.i
  %.1356.2.i152.i = fmul double %.1349.2.i151.i, %.1349.2.i151.i
  %.1358.2.i153.i = fadd double %.1356.2.i152.i, %.1358.1.i148.i
  %.1350.i154.i = fmul double %.1028.i100.i, %.1349.i135.i
  %.1352.i155.i = fadd double %.1350.i154.i, 0.000000e+00
  %.1350.1.i156.i = fmul double %.1028.1.i109.i, %.1349.1.i146.i
  %.1352.1.i157.i = fadd double %.1352.i155.i, %.1350.1.i156.i
  %.1350.2.i158.i = fmul double %.1028.2.i114.i, %.1349.2.i151.i
  %.1352.2.i159.i = fadd double %.1350.2.i158.i, %.1352.1.i157.i
  %.1380.i160.i = fmul double %.1355.2.i116.i, %.1358.2.i153.i
  %sqrt.i161.i = tail call double @llvm.sqrt.f64(double %.1380.i160.i)
  %.1386.i162.i = fmul double %sqrt.i161.i, 5.000000e-01
  %.1388.i163.i = fcmp ole double %.1352.2.i159.i, %.1386.i162.i
  %brmerge.i164.i = or i1 %49, %.1388.i163.i
  br i1 %brmerge.i164.i, label %B482.endif.endif.i, label %B92.endif.backedge.i68.i

B705.i67.i:                                       ; preds = %B92.endif.i57.i, %B632.i75.i, %B158.i71.i
  br i1 %49, label %B536.i, label %B92.endif.backedge.i68.i

B92.endif.backedge.i68.i:                         ; preds = %B705.i67.i, %B644.i118.i
  %lsr.iv.next.i69.i = add nuw i64 %lsr.iv.i58.i, 1
  br label %B92.endif.i57.i

B92.endif.i57.i:                                  ; preds = %B92.endif.backedge.i68.i, %B92.lr.ph.i30.i
  %lsr.iv.i58.i = phi i64 [ %lsr.iv.next.i69.i, %B92.endif.backedge.i68.i ], [ 1, %B92.lr.ph.i30.i ]
  %48 = shl i64 %lsr.iv.i58.i, 3
  %scevgep.i59.i = getelementptr i8, ptr %45, i64 %48
  %scevgep18.i60.i = getelementptr i8, ptr %scevgep.i59.i, i64 -8
  %.339.i61.i = load i64, ptr %scevgep18.i60.i, align 8
  %49 = icmp eq i64 %.158.i28.i, %lsr.iv.i58.i
  %iv.rem.i62.i = select i1 %49, i64 0, i64 %lsr.iv.i58.i
  %50 = getelementptr i64, ptr %45, i64 %iv.rem.i62.i
  %.432.i63.i = load i64, ptr %50, align 8
  %.84.i12.i64.i = icmp ne i64 %one.2.2.i, %.339.i61.i
  %.84.1.i13.i65.i = icmp ne i64 %two.2.2.i, %.339.i61.i
  %or.cond.i14.not.i66.i = select i1 %.84.i12.i64.i, i1 %.84.1.i13.i65.i, i1 false
  br i1 %or.cond.i14.not.i66.i, label %B158.i71.i, label %B705.i67.i

B520.i:                                           ; preds = %B482.endif.endif.i, %B444.endif.endif.i
  %sunkaddr337.i = shl i64 %.369.i, 3
  %sunkaddr338.i = getelementptr i8, ptr %w27, i64 %sunkaddr337.i
  store i64 -1, ptr %sunkaddr338.i, align 8
  br label %B733.i

B536.i:                                           ; preds = %B705.i67.i, %B482.endif.endif.i, %B320.endif.endif.i, %B482.i
  %.59.i.i.i = select i1 %.1115.i, i64 %w4, i64 0
  %.60.i.i.i = add i64 %.59.i.i.i, %one.2.2.i
  %.80.i.i.i = mul i64 %.60.i.i.i, %w5
  %.84.i.i1.i = getelementptr i64, ptr %w3, i64 %.80.i.i.i
  %.85.i.i.i = load i64, ptr %.84.i.i1.i, align 8
  %.87.not.i.i.i = icmp eq i64 %.85.i.i.i, %two.2.2.i
  br i1 %.87.not.i.i.i, label %B0.endif.i.i, label %B36.preheader.i.i.i

B36.preheader.i.i.i:                              ; preds = %B536.i
  %51 = shl i64 %.80.i.i.i, 3
  %52 = getelementptr i8, ptr %w3, i64 %51
  %scevgep.i.i.i = getelementptr i8, ptr %52, i64 8
  br label %B36.i.i.i

B36.i.i.i:                                        ; preds = %B36.i.i.i, %B36.preheader.i.i.i
  %slot.2.0.i.i.i = phi i64 [ %.90.i.i.i, %B36.i.i.i ], [ 0, %B36.preheader.i.i.i ]
  %.90.i.i.i = add i64 %slot.2.0.i.i.i, 1
  %53 = shl i64 %slot.2.0.i.i.i, 3
  %scevgep1.i.i.i = getelementptr i8, ptr %scevgep.i.i.i, i64 %53
  %.145.i.i.i = load i64, ptr %scevgep1.i.i.i, align 8
  %.147.not.i.i.i = icmp eq i64 %.145.i.i.i, %two.2.2.i
  br i1 %.147.not.i.i.i, label %B0.endif.i.i, label %B36.i.i.i

B274.i.i:                                         ; preds = %B274.lr.ph.i.i, %B526.i.i
  %.612978980.i.i = phi i64 [ 0, %B274.lr.ph.i.i ], [ %.619.i.i, %B526.i.i ]
  %.619.i.i = add nuw nsw i64 %.612978980.i.i, 1
  %54 = shl i64 %.612978980.i.i, 3
  %scevgep81.i.i = getelementptr i8, ptr %w35, i64 %54
  store i64 -1, ptr %scevgep81.i.i, align 8
  %scevgep82.i.i = getelementptr i8, ptr %5, i64 %54
  store i64 0, ptr %scevgep82.i.i, align 8
  %.791.i.i = load i64, ptr %sunkaddr30.i.i, align 8
  %.792.i.i = add nsw i64 %.791.i.i, -1
  %.794.i.i = icmp slt i64 %.612978980.i.i, %.792.i.i
  br i1 %.794.i.i, label %B336.i.i, label %B376.i.i

B336.i.i:                                         ; preds = %B274.i.i
  %55 = add i64 %.612978980.i.i, %.139.i.i
  %.833.i.i = icmp eq i64 %.791.i.i, 0
  br i1 %.833.i.i, label %B432.i.i, label %B336.else.i.i

B376.i.i:                                         ; preds = %B274.i.i
  %56 = add i64 %.612978980.i.i, %slot.3.1.i33.i.i
  %57 = sub i64 %56, %.791.i.i
  %.945.i.i = load i64, ptr %sunkaddr31.i.i, align 8
  %.948.i.i = icmp eq i64 %.945.i.i, 0
  br i1 %.948.i.i, label %B432.i.i, label %B376.else.i.i

B432.i.i:                                         ; preds = %134, %B376.else.i.i, %123, %B336.else.i.i, %B376.i.i, %B336.i.i
  %at.3.1.i.i = phi i64 [ %spec.select970.i.i, %123 ], [ 0, %B336.i.i ], [ 0, %B336.else.i.i ], [ %spec.select971.i.i, %134 ], [ 0, %B376.i.i ], [ 0, %B376.else.i.i ]
  %source.2.1.i.i = phi i64 [ %one.2.2.i, %123 ], [ %one.2.2.i, %B336.i.i ], [ %one.2.2.i, %B336.else.i.i ], [ %two.2.2.i, %134 ], [ %two.2.2.i, %B376.i.i ], [ %two.2.2.i, %B376.else.i.i ]
  %.994.i.i = icmp slt i64 %.612978980.i.i, %.510.i.i
  br i1 %.994.i.i, label %B444.i.i, label %B526.i.i

B444.i.i:                                         ; preds = %B432.i.i
  %.1020.i.i = icmp slt i64 %source.2.1.i.i, 0
  %.1021.i.i = select i1 %.1020.i.i, i64 %w4, i64 0
  %.1022.i11.i = add i64 %.1021.i.i, %source.2.1.i.i
  %.1023.i12.i = icmp slt i64 %at.3.1.i.i, 0
  %.1024.i13.i = select i1 %.1023.i12.i, i64 %w5, i64 0
  %.1042.i.i = mul i64 %.1022.i11.i, %w5
  %58 = getelementptr i64, ptr %w3, i64 %.1042.i.i
  %59 = getelementptr i64, ptr %58, i64 %at.3.1.i.i
  %.1046.i.i = getelementptr i64, ptr %59, i64 %.1024.i13.i
  %.1047.i.i = load i64, ptr %.1046.i.i, align 8
  store i64 %.1047.i.i, ptr %scevgep81.i.i, align 8
  %.1130.i14.i = select i1 %.1020.i.i, i64 %w9, i64 0
  %.1131.i.i = add i64 %.1130.i14.i, %source.2.1.i.i
  %.1133.i.i = select i1 %.1023.i12.i, i64 %w10, i64 0
  %.1151.i.i = mul i64 %.1131.i.i, %w10
  %60 = getelementptr i64, ptr %w8, i64 %.1151.i.i
  %61 = getelementptr i64, ptr %60, i64 %at.3.1.i.i
  %.1155.i.i = getelementptr i64, ptr %61, i64 %.1133.i.i
  %.1156.i.i = load i64, ptr %.1155.i.i, align 8
  %.1159.i.i = icmp eq i64 %source.2.1.i.i, %two.2.2.i
  %spec.select.i.i = select i1 %.1159.i.i, i64 %.443.i.i, i64 0
  %.1176.i.i = add nsw i64 %.1156.i.i, %spec.select.i.i
  store i64 %.1176.i.i, ptr %scevgep82.i.i, align 8
  br label %B526.i.i

B526.i.i:                                         ; preds = %B444.i.i, %B432.i.i
  %exitcond.not.i.i = icmp eq i64 %w5, %.619.i.i
  br i1 %exitcond.not.i.i, label %B528.endif.loopexit.i.i, label %B274.i.i

B572.i.i:                                         ; preds = %B528.endif.i.i, %B1037.i.i
  %.13709911003.i.i = phi i64 [ %.1377.i.i, %B1037.i.i ], [ 0, %B528.endif.i.i ]
  %.1377.i.i = add nuw nsw i64 %.13709911003.i.i, 1
  %62 = getelementptr i64, ptr %.84.i22.i.i, i64 %.13709911003.i.i
  %.1452.i.i = load i64, ptr %62, align 8
  %.1458.i.i = icmp eq i64 %.1452.i.i, %one.2.2.i
  br i1 %.1458.i.i, label %B1037.i.i, label %B608.i.i

B608.i.i:                                         ; preds = %B572.i.i
  %.58.i1.i.i = icmp slt i64 %.1452.i.i, 0
  %.59.i2.i.i = select i1 %.58.i1.i.i, i64 %w4, i64 0
  %.60.i3.i.i = add i64 %.59.i2.i.i, %.1452.i.i
  %.80.i4.i.i = mul i64 %.60.i3.i.i, %w5
  %.84.i5.i.i = getelementptr i64, ptr %w3, i64 %.80.i4.i.i
  %.85.i6.i.i = load i64, ptr %.84.i5.i.i, align 8
  %.87.not.i7.i.i = icmp eq i64 %.85.i6.i.i, %two.2.2.i
  br i1 %.87.not.i7.i.i, label %B608.endif.i.i, label %B36.preheader.i8.i.i

B36.preheader.i8.i.i:                             ; preds = %B608.i.i
  %63 = shl i64 %.80.i4.i.i, 3
  %64 = getelementptr i8, ptr %w3, i64 %63
  %scevgep.i9.i.i = getelementptr i8, ptr %64, i64 8
  br label %B36.i10.i.i

B36.i10.i.i:                                      ; preds = %B36.i10.i.i, %B36.preheader.i8.i.i
  %slot.2.0.i11.i.i = phi i64 [ %.90.i12.i.i, %B36.i10.i.i ], [ 0, %B36.preheader.i8.i.i ]
  %.90.i12.i.i = add i64 %slot.2.0.i11.i.i, 1
  %65 = shl i64 %slot.2.0.i11.i.i, 3
  %scevgep1.i13.i.i = getelementptr i8, ptr %scevgep.i9.i.i, i64 %65
  %.145.i14.i.i = load i64, ptr %scevgep1.i13.i.i, align 8
  %.147.not.i15.i.i = icmp eq i64 %.145.i14.i.i, %two.2.2.i
  br i1 %.147.not.i15.i.i, label %B608.endif.i.i, label %B36.i10.i.i

B666.i.i:                                         ; preds = %B608.endif.i.i
  %66 = getelementptr i64, ptr %.84.i5.i.i, i64 %slot.3.1.i16.i.i
  store i64 %one.2.2.i, ptr %66, align 8
  %.1588.i.i = select i1 %.58.i1.i.i, i64 %w9, i64 0
  %.1589.i.i = add i64 %.1588.i.i, %.1452.i.i
  %.1609.i.i = mul i64 %.1589.i.i, %w10
  %67 = getelementptr i64, ptr %w8, i64 %.1609.i.i
  %68 = getelementptr i64, ptr %67, i64 %slot.3.1.i16.i.i
  %.1614.i.i = load i64, ptr %68, align 8
  %.1616.i.i = sub nsw i64 %.1614.i.i, %.443.i.i
  store i64 %.1616.i.i, ptr %68, align 8
  br label %B1037.i.i

B796.i.i:                                         ; preds = %B796.prol.loopexit.i.i, %B796.i.i
  %.1848984986.i.i = phi i64 [ %79, %B796.i.i ], [ %.1848984986.unr.i.i, %B796.prol.loopexit.i.i ]
  %.1907.i.i = icmp slt i64 %.1848984986.i.i, -1
  %69 = shl i64 %.1848984986.i.i, 3
  %70 = select i1 %.1907.i.i, i64 %6, i64 8
  %scevgep25.i.i = getelementptr i8, ptr %.84.i5.i.i, i64 %70
  %scevgep26.i.i = getelementptr i8, ptr %scevgep25.i.i, i64 %69
  %.1931.i.i = load i64, ptr %scevgep26.i.i, align 8
  %71 = select i1 %.1907.i.i, i64 %7, i64 8
  %scevgep23.i.i = getelementptr i8, ptr %137, i64 %71
  %scevgep24.i.i = getelementptr i8, ptr %scevgep23.i.i, i64 %69
  %.1983.i.i = load i64, ptr %scevgep24.i.i, align 8
  %.2010.i.i = icmp slt i64 %.1848984986.i.i, 0
  %72 = select i1 %.2010.i.i, i64 %s8, i64 0
  %scevgep67.i.i = getelementptr i8, ptr %.84.i5.i.i, i64 %72
  %scevgep22.i.i = getelementptr i8, ptr %scevgep67.i.i, i64 %69
  store i64 %.1931.i.i, ptr %scevgep22.i.i, align 8
  %73 = select i1 %.2010.i.i, i64 %s16, i64 0
  %scevgep65.i.i = getelementptr i8, ptr %137, i64 %73
  %scevgep21.i.i = getelementptr i8, ptr %scevgep65.i.i, i64 %69
  store i64 %.1983.i.i, ptr %scevgep21.i.i, align 8
  %74 = add i64 %.1848984986.i.i, 1
  %.1907.1.i.i = icmp slt i64 %74, -1
  %75 = select i1 %.1907.1.i.i, i64 %8, i64 16
  %scevgep19.i.i = getelementptr i8, ptr %.84.i5.i.i, i64 %75
  %scevgep20.i.i = getelementptr i8, ptr %scevgep19.i.i, i64 %69
  %.1931.1.i.i = load i64, ptr %scevgep20.i.i, align 8
  %76 = select i1 %.1907.1.i.i, i64 %9, i64 16
  %scevgep17.i.i = getelementptr i8, ptr %137, i64 %76
  %scevgep18.i6.i = getelementptr i8, ptr %scevgep17.i.i, i64 %69
  %.1983.1.i.i = load i64, ptr %scevgep18.i6.i, align 8
  %.2010.1.i.i = icmp slt i64 %74, 0
  %77 = select i1 %.2010.1.i.i, i64 %6, i64 8
  %scevgep15.i.i = getelementptr i8, ptr %.84.i5.i.i, i64 %77
  %scevgep16.i.i = getelementptr i8, ptr %scevgep15.i.i, i64 %69
  store i64 %.1931.1.i.i, ptr %scevgep16.i.i, align 8
  %78 = select i1 %.2010.1.i.i, i64 %7, i64 8
  %scevgep13.i.i = getelementptr i8, ptr %137, i64 %78
  %scevgep14.i.i = getelementptr i8, ptr %scevgep13.i.i, i64 %69
  store i64 %.1983.1.i.i, ptr %scevgep14.i.i, align 8
  %79 = add i64 %.1848984986.i.i, 2
  %exitcond.not36.1.i.i = icmp eq i64 %79, %.1697.i.i
  br i1 %exitcond.not36.1.i.i, label %B874.loopexit.i.i, label %B796.i.i

B874.loopexit.i.i:                                ; preds = %B796.i.i, %B796.prol.loopexit.i.i
  %sunkaddr93.i.i = shl i64 %.1681.i.i, 3
  %sunkaddr94.i.i = getelementptr inbounds i8, ptr %136, i64 %sunkaddr93.i.i
  %.2121.pre.i.i = load i64, ptr %sunkaddr94.i.i, align 8
  br label %B874.i.i

B874.i.i:                                         ; preds = %B718.endif.i.i, %B874.loopexit.i.i
  %.2121.i.i = phi i64 [ %.2121.pre.i.i, %B874.loopexit.i.i ], [ %.1697.i.i, %B718.endif.i.i ]
  %.2150.i.i = icmp slt i64 %.2121.i.i, 0
  %.2151.i.i = select i1 %.2150.i.i, i64 %w5, i64 0
  %80 = getelementptr i64, ptr %.84.i5.i.i, i64 %.2121.i.i
  %.2173.i.i = getelementptr i64, ptr %80, i64 %.2151.i.i
  store i64 -1, ptr %.2173.i.i, align 8
  br label %B1037.i.i

B956.i.i:                                         ; preds = %B956.lr.ph.new.i.i, %B956.i.i
  %.228410101012.i.i = phi i64 [ 0, %B956.lr.ph.new.i.i ], [ %.2291.1.i.i, %B956.i.i ]
  %81 = shl i64 %.228410101012.i.i, 3
  %sunkaddr37.i.i = getelementptr i8, ptr %w35, i64 %81
  %.2369.i.i = load i64, ptr %sunkaddr37.i.i, align 8
  %scevgep45.i.i = getelementptr i8, ptr %scevgep43.i.i, i64 %81
  %scevgep12.i.i = getelementptr i8, ptr %scevgep45.i.i, i64 -8
  store i64 %.2369.i.i, ptr %scevgep12.i.i, align 8
  %scevgep2.i.i = getelementptr i8, ptr %scevgep47.i.i, i64 %81
  %scevgep3.i8.i = getelementptr i8, ptr %scevgep2.i.i, i64 -8
  store i64 -1, ptr %scevgep3.i8.i, align 8
  %scevgep4.i.i = getelementptr i8, ptr %scevgep51.i.i, i64 %81
  %scevgep6.i.i = getelementptr i8, ptr %scevgep4.i.i, i64 -8
  %.2525.i.i = load i64, ptr %scevgep6.i.i, align 8
  %scevgep.i9.i = getelementptr i8, ptr %scevgep55.i.i, i64 %81
  %scevgep1.i.i = getelementptr i8, ptr %scevgep.i9.i, i64 -8
  store i64 %.2525.i.i, ptr %scevgep1.i.i, align 8
  %.2291.1.i.i = add nuw i64 %.228410101012.i.i, 2
  %sunkaddr40.i.i = getelementptr i8, ptr %sunkaddr37.i.i, i64 8
  %.2369.1.i.i = load i64, ptr %sunkaddr40.i.i, align 8
  store i64 %.2369.1.i.i, ptr %scevgep45.i.i, align 8
  store i64 -1, ptr %scevgep2.i.i, align 8
  %.2525.1.i.i = load i64, ptr %scevgep4.i.i, align 8
  store i64 %.2525.1.i.i, ptr %scevgep.i9.i, align 8
  %niter.ncmp.1.i.i = icmp eq i64 %unroll_iter.i7.i, %.2291.1.i.i
  br i1 %niter.ncmp.1.i.i, label %common.ret.loopexit.unr-lcssa.i10.i, label %B956.i.i

common.ret.loopexit.unr-lcssa.i10.i:              ; preds = %B956.i.i
  br i1 %lcmp.mod38.not.i.i, label %_ZN7msf_jax4host4meso7kernels11merge_ringsB3v62B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx5ArrayIxLi2E1C7mutable7alignedE.exit.i, label %B956.epil.preheader.i.i

B956.epil.preheader.i.i:                          ; preds = %B956.lr.ph.i.i, %common.ret.loopexit.unr-lcssa.i10.i
  %.2369.epil.i.i = load i64, ptr %.2368.epil.i.i, align 8
  %.2419.epil.i.i = getelementptr i64, ptr %.84.i.i1.i, i64 %unroll_iter.i7.i
  store i64 %.2369.epil.i.i, ptr %.2419.epil.i.i, align 8
  %.2470.epil.i.i = getelementptr i64, ptr %.84.i22.i.i, i64 %unroll_iter.i7.i
  store i64 -1, ptr %.2470.epil.i.i, align 8
  %.2525.epil.i.i = load i64, ptr %.2524.epil.i.i, align 8
  %82 = getelementptr i64, ptr %109, i64 %unroll_iter.i7.i
  store i64 %.2525.epil.i.i, ptr %82, align 8
  br label %_ZN7msf_jax4host4meso7kernels11merge_ringsB3v62B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx5ArrayIxLi2E1C7mutable7alignedE.exit.i

B1037.i.i:                                        ; preds = %B874.i.i, %B666.i.i, %B572.i.i
  %exitcond1018.not.i.i = icmp eq i64 %.1377.i.i, %.1284.i.i
  br i1 %exitcond1018.not.i.i, label %B902.endif.i.i, label %B572.i.i

B0.endif.i.i:                                     ; preds = %B36.i.i.i, %B536.i
  %slot.3.1.i.i.i = phi i64 [ 0, %B536.i ], [ %.90.i.i.i, %B36.i.i.i ]
  %.58.i18.i.i = icmp slt i64 %two.2.2.i, 0
  %.59.i19.i.i = select i1 %.58.i18.i.i, i64 %w4, i64 0
  %.60.i20.i.i = add i64 %.59.i19.i.i, %two.2.2.i
  %.80.i21.i.i = mul i64 %.60.i20.i.i, %w5
  %.84.i22.i.i = getelementptr i64, ptr %w3, i64 %.80.i21.i.i
  %.85.i23.i.i = load i64, ptr %.84.i22.i.i, align 8
  %.87.not.i24.i.i = icmp eq i64 %.85.i23.i.i, %one.2.2.i
  br i1 %.87.not.i24.i.i, label %B0.endif.endif.i.i, label %B36.i27.i.i

B36.i27.i.i:                                      ; preds = %B0.endif.i.i, %B36.i27.i.i
  %lsr.iv.i2.i = phi i64 [ %lsr.iv.next.i3.i, %B36.i27.i.i ], [ 3, %B0.endif.i.i ]
  %83 = shl i64 %lsr.iv.i2.i, 3
  %scevgep83.i.i = getelementptr i8, ptr %.84.i22.i.i, i64 %83
  %scevgep84.i.i = getelementptr i8, ptr %scevgep83.i.i, i64 -16
  %.145.i31.i.i = load i64, ptr %scevgep84.i.i, align 8
  %.147.not.i32.i.i = icmp eq i64 %.145.i31.i.i, %one.2.2.i
  %lsr.iv.next.i3.i = add i64 %lsr.iv.i2.i, 1
  br i1 %.147.not.i32.i.i, label %B0.endif.endif.i.i, label %B36.i27.i.i

B0.endif.endif.i.i:                               ; preds = %B36.i27.i.i, %B0.endif.i.i
  %slot.3.1.i33.i.i = phi i64 [ 3, %B0.endif.i.i ], [ %lsr.iv.next.i3.i, %B36.i27.i.i ]
  %.139.i.i = add i64 %slot.3.1.i.i.i, 1
  %.155.i.i = select i1 %.1115.i, i64 %w7, i64 0
  %84 = getelementptr i64, ptr %w6, i64 %one.2.2.i
  %.169.i.i = getelementptr i64, ptr %84, i64 %.155.i.i
  %.170.i.i = load i64, ptr %.169.i.i, align 8
  %.173.i.i = icmp eq i64 %.170.i.i, 0
  br i1 %.173.i.i, label %B0.endif.endif.endif.endif.endif.thread.i.i, label %B0.endif.endif.endif.i.i

B0.endif.endif.endif.i.i:                         ; preds = %B0.endif.endif.i.i
  %85 = or i64 %.170.i.i, %.139.i.i
  %86 = icmp ult i64 %85, 4294967296
  br i1 %86, label %87, label %92

87:                                               ; preds = %B0.endif.endif.endif.i.i
  %88 = trunc nuw i64 %.170.i.i to i32
  %89 = trunc nuw i64 %.139.i.i to i32
  %90 = urem i32 %89, %88
  %91 = zext i32 %90 to i64
  br label %94

92:                                               ; preds = %B0.endif.endif.endif.i.i
  %93 = srem i64 %.139.i.i, %.170.i.i
  br label %94

94:                                               ; preds = %92, %87
  %95 = phi i64 [ %91, %87 ], [ %93, %92 ]
  %.191.i.i = xor i64 %95, %.170.i.i
  %.192.i.i = icmp slt i64 %.191.i.i, 0
  %.193.i.i = icmp ne i64 %95, 0
  %.194.i.i = and i1 %.193.i.i, %.192.i.i
  %.201.i.i = select i1 %.194.i.i, i64 %.170.i.i, i64 0
  %spec.select968.i.i = add i64 %.201.i.i, %95
  %spec.select968.fr.i.i = freeze i64 %spec.select968.i.i
  %.237.i.i = icmp slt i64 %spec.select968.fr.i.i, 0
  %spec.select1040.i.i = select i1 %.237.i.i, i64 %w5, i64 0
  %96 = getelementptr i64, ptr %.84.i.i1.i, i64 %spec.select968.fr.i.i
  %.2601034.i.i = getelementptr i64, ptr %96, i64 %spec.select1040.i.i
  %.2611035.i.i = load i64, ptr %.2601034.i.i, align 8
  %.2631036.i.i = add nsw i64 %slot.3.1.i.i.i, -1
  %.308.i.i = icmp ne i64 %.2631036.i.i, -9223372036854775808
  %.309.i.i = icmp ne i64 %.170.i.i, -1
  %.310.not.i.i = or i1 %.308.i.i, %.309.i.i
  br i1 %.310.not.i.i, label %B0.endif.endif.endif.else.if.i.i, label %B0.endif.endif.endif.endif.endif.thread.i.i

B0.endif.endif.endif.else.if.i.i:                 ; preds = %94
  %97 = or i64 %.170.i.i, %.2631036.i.i
  %98 = icmp ult i64 %97, 4294967296
  br i1 %98, label %99, label %104

99:                                               ; preds = %B0.endif.endif.endif.else.if.i.i
  %100 = trunc nuw i64 %.170.i.i to i32
  %101 = trunc nuw i64 %.2631036.i.i to i32
  %102 = urem i32 %101, %100
  %103 = zext i32 %102 to i64
  br label %106

104:                                              ; preds = %B0.endif.endif.endif.else.if.i.i
  %105 = srem i64 %.2631036.i.i, %.170.i.i
  br label %106

106:                                              ; preds = %104, %99
  %107 = phi i64 [ %103, %99 ], [ %105, %104 ]
  %.315.i.i = xor i64 %107, %.170.i.i
  %.316.i.i = icmp slt i64 %.315.i.i, 0
  %.317.i.i = icmp ne i64 %107, 0
  %.318.i.i = and i1 %.317.i.i, %.316.i.i
  %.325.i.i = select i1 %.318.i.i, i64 %.170.i.i, i64 0
  %spec.select969.i.i = add i64 %.325.i.i, %107
  %spec.select969.fr.i.i = freeze i64 %spec.select969.i.i
  %.361.i.i = icmp slt i64 %spec.select969.fr.i.i, 0
  %.362.i.i = select i1 %.361.i.i, i64 %w5, i64 0
  %108 = getelementptr i64, ptr %.84.i.i1.i, i64 %.362.i.i
  %.384.phi.trans.insert.i.i = getelementptr i64, ptr %108, i64 %spec.select969.fr.i.i
  %.385.pre.i.i = load i64, ptr %.384.phi.trans.insert.i.i, align 8
  br label %B0.endif.endif.endif.endif.endif.thread.i.i

B0.endif.endif.endif.endif.endif.thread.i.i:      ; preds = %106, %94, %B0.endif.endif.i.i
  %.385.i.i = phi i64 [ %.85.i.i.i, %94 ], [ %.385.pre.i.i, %106 ], [ %.85.i.i.i, %B0.endif.endif.i.i ]
  %.2611038.i.i = phi i64 [ %.2611035.i.i, %94 ], [ %.2611035.i.i, %106 ], [ %.85.i.i.i, %B0.endif.endif.i.i ]
  %.417.i.i = select i1 %.1115.i, i64 %w9, i64 0
  %.418.i.i = add i64 %.417.i.i, %one.2.2.i
  %.438.i.i = mul i64 %.418.i.i, %w10
  %109 = getelementptr i64, ptr %w8, i64 %.438.i.i
  %110 = getelementptr i64, ptr %109, i64 %slot.3.1.i.i.i
  %.443.i.i = load i64, ptr %110, align 8
  %.493.i.i = select i1 %.58.i18.i.i, i64 %w7, i64 0
  %111 = getelementptr i64, ptr %w6, i64 %two.2.2.i
  %.507.i.i = getelementptr i64, ptr %111, i64 %.493.i.i
  %.508.i.i = load i64, ptr %.507.i.i, align 8
  %.509.i.i = add i64 %.170.i.i, -4
  %.510.i.i = add i64 %.509.i.i, %.508.i.i
  br i1 %.564.i.i, label %B274.lr.ph.i.i, label %B528.endif.i.i

B274.lr.ph.i.i:                                   ; preds = %B0.endif.endif.endif.endif.endif.thread.i.i
  %112 = xor i64 %slot.3.1.i33.i.i, -9223372036854775808
  %113 = add i64 %slot.3.1.i.i.i, 9223372036854775807
  %sunkaddr29.i.i = shl i64 %.155.i.i, 3
  %sunkaddr30.i.i = getelementptr i8, ptr %84, i64 %sunkaddr29.i.i
  %sunkaddr.i.i = shl i64 %.493.i.i, 3
  %sunkaddr31.i.i = getelementptr i8, ptr %111, i64 %sunkaddr.i.i
  br label %B274.i.i

B336.else.i.i:                                    ; preds = %B336.i.i
  %114 = add i64 %113, %.612978980.i.i
  %.844.i.i = icmp ne i64 %114, -2
  %.845.i16.i = icmp ne i64 %.791.i.i, -1
  %.846.not.i.i = or i1 %.844.i.i, %.845.i16.i
  br i1 %.846.not.i.i, label %B336.else.if.i.i, label %B432.i.i

B336.else.if.i.i:                                 ; preds = %B336.else.i.i
  %115 = or i64 %.791.i.i, %55
  %116 = icmp ult i64 %115, 4294967296
  br i1 %116, label %117, label %121

117:                                              ; preds = %B336.else.if.i.i
  %118 = trunc nuw i64 %.791.i.i to i32
  %tmp27.i.i = trunc nuw i64 %55 to i32
  %119 = urem i32 %tmp27.i.i, %118
  %120 = zext i32 %119 to i64
  br label %123

121:                                              ; preds = %B336.else.if.i.i
  %122 = srem i64 %55, %.791.i.i
  br label %123

123:                                              ; preds = %121, %117
  %124 = phi i64 [ %120, %117 ], [ %122, %121 ]
  %.851.i17.i = xor i64 %124, %.791.i.i
  %.852.i.i = icmp slt i64 %.851.i17.i, 0
  %.853.i.i = icmp ne i64 %124, 0
  %.854.i.i = and i1 %.853.i.i, %.852.i.i
  %.861.i.i = select i1 %.854.i.i, i64 %.791.i.i, i64 0
  %spec.select970.i.i = add i64 %.861.i.i, %124
  br label %B432.i.i

B376.else.i.i:                                    ; preds = %B376.i.i
  %125 = add i64 %.612978980.i.i, %112
  %.959.i.i = icmp ne i64 %125, %.791.i.i
  %.960.i.i = icmp ne i64 %.945.i.i, -1
  %.961.not.i.i = or i1 %.959.i.i, %.960.i.i
  br i1 %.961.not.i.i, label %B376.else.if.i.i, label %B432.i.i

B376.else.if.i.i:                                 ; preds = %B376.else.i.i
  %126 = or i64 %.945.i.i, %57
  %127 = icmp ult i64 %126, 4294967296
  br i1 %127, label %128, label %132

128:                                              ; preds = %B376.else.if.i.i
  %129 = trunc nuw i64 %.945.i.i to i32
  %tmp.i.i = trunc nuw i64 %57 to i32
  %130 = urem i32 %tmp.i.i, %129
  %131 = zext i32 %130 to i64
  br label %134

132:                                              ; preds = %B376.else.if.i.i
  %133 = srem i64 %57, %.945.i.i
  br label %134

134:                                              ; preds = %132, %128
  %135 = phi i64 [ %131, %128 ], [ %133, %132 ]
  %.966.i15.i = xor i64 %135, %.945.i.i
  %.967.i.i = icmp slt i64 %.966.i15.i, 0
  %.968.i.i = icmp ne i64 %135, 0
  %.969.i.i = and i1 %.968.i.i, %.967.i.i
  %.976.i.i = select i1 %.969.i.i, i64 %.945.i.i, i64 0
  %spec.select971.i.i = add i64 %.976.i.i, %135
  br label %B432.i.i

B528.endif.loopexit.i.i:                          ; preds = %B526.i.i
  %.1284.pre.i.i = load i64, ptr %sunkaddr31.i.i, align 8
  br label %B528.endif.i.i

B528.endif.i.i:                                   ; preds = %B528.endif.loopexit.i.i, %B0.endif.endif.endif.endif.endif.thread.i.i
  %.1284.i.i = phi i64 [ %.1284.pre.i.i, %B528.endif.loopexit.i.i ], [ %.508.i.i, %B0.endif.endif.endif.endif.endif.thread.i.i ]
  %.13641000.not.i.i = icmp slt i64 %.1284.i.i, 1
  br i1 %.13641000.not.i.i, label %B902.endif.i.i, label %B572.i.i

B608.endif.i.i:                                   ; preds = %B36.i10.i.i, %B608.i.i
  %slot.3.1.i16.i.i = phi i64 [ 0, %B608.i.i ], [ %.90.i12.i.i, %B36.i10.i.i ]
  %.1500.i.i = icmp ne i64 %.1452.i.i, %.2611038.i.i
  %.1504.i.i = icmp ne i64 %.1452.i.i, %.385.i.i
  %or.cond.i.i = select i1 %.1500.i.i, i1 %.1504.i.i, i1 false
  br i1 %or.cond.i.i, label %B666.i.i, label %B718.endif.i.i

B718.endif.i.i:                                   ; preds = %B608.endif.i.i
  %.1681.i.i = select i1 %.58.i1.i.i, i64 %w7, i64 0
  %136 = getelementptr i64, ptr %w6, i64 %.1452.i.i
  %.1695.i.i = getelementptr i64, ptr %136, i64 %.1681.i.i
  %.1696.i.i = load i64, ptr %.1695.i.i, align 8
  %.1697.i.i = add nsw i64 %.1696.i.i, -1
  store i64 %.1697.i.i, ptr %.1695.i.i, align 8
  %.1799.i.i = sub i64 %.1697.i.i, %slot.3.1.i16.i.i
  %.1842985.not.i.i = icmp slt i64 %.1799.i.i, 1
  br i1 %.1842985.not.i.i, label %B874.i.i, label %B796.lr.ph.i.i

B796.lr.ph.i.i:                                   ; preds = %B718.endif.i.i
  %.1957.i.i = select i1 %.58.i1.i.i, i64 %w9, i64 0
  %.1958.i.i = add i64 %.1957.i.i, %.1452.i.i
  %.1978.i.i = mul i64 %.1958.i.i, %w10
  %137 = getelementptr i64, ptr %w8, i64 %.1978.i.i
  %138 = add i64 %.1696.i.i, -2
  %xtraiter.i4.i = and i64 %.1799.i.i, 1
  %lcmp.mod.not.i5.i = icmp eq i64 %xtraiter.i4.i, 0
  br i1 %lcmp.mod.not.i5.i, label %B796.prol.loopexit.i.i, label %B796.prol.i.i

B796.prol.i.i:                                    ; preds = %B796.lr.ph.i.i
  %.1855.prol.i.i = add i64 %slot.3.1.i16.i.i, 1
  %.1907.prol.i.i = icmp slt i64 %slot.3.1.i16.i.i, -1
  %.1908.prol.i.i = select i1 %.1907.prol.i.i, i64 %w5, i64 0
  %139 = getelementptr i64, ptr %.84.i5.i.i, i64 %.1855.prol.i.i
  %.1930.prol.i.i = getelementptr i64, ptr %139, i64 %.1908.prol.i.i
  %.1931.prol.i.i = load i64, ptr %.1930.prol.i.i, align 8
  %.1960.prol.i.i = select i1 %.1907.prol.i.i, i64 %w10, i64 0
  %140 = getelementptr i64, ptr %137, i64 %.1855.prol.i.i
  %.1982.prol.i.i = getelementptr i64, ptr %140, i64 %.1960.prol.i.i
  %.1983.prol.i.i = load i64, ptr %.1982.prol.i.i, align 8
  %141 = getelementptr i64, ptr %.84.i5.i.i, i64 %slot.3.1.i16.i.i
  store i64 %.1931.prol.i.i, ptr %141, align 8
  %142 = getelementptr i64, ptr %137, i64 %slot.3.1.i16.i.i
  store i64 %.1983.prol.i.i, ptr %142, align 8
  br label %B796.prol.loopexit.i.i

B796.prol.loopexit.i.i:                           ; preds = %B796.prol.i.i, %B796.lr.ph.i.i
  %.1848984986.unr.i.i = phi i64 [ %slot.3.1.i16.i.i, %B796.lr.ph.i.i ], [ %.1855.prol.i.i, %B796.prol.i.i ]
  %143 = icmp eq i64 %138, %slot.3.1.i16.i.i
  br i1 %143, label %B874.loopexit.i.i, label %B796.i.i

B902.endif.i.i:                                   ; preds = %B1037.i.i, %B528.endif.i.i
  br i1 %.22781011.not.i.i, label %_ZN7msf_jax4host4meso7kernels11merge_ringsB3v62B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx5ArrayIxLi2E1C7mutable7alignedE.exit.i, label %B956.lr.ph.i.i

B956.lr.ph.i.i:                                   ; preds = %B902.endif.i.i
  br i1 %10, label %B956.epil.preheader.i.i, label %B956.lr.ph.new.i.i

B956.lr.ph.new.i.i:                               ; preds = %B956.lr.ph.i.i
  %144 = shl i64 %.80.i.i.i, 3
  %145 = getelementptr i8, ptr %w3, i64 %144
  %scevgep43.i.i = getelementptr i8, ptr %145, i64 8
  %146 = shl i64 %.80.i21.i.i, 3
  %147 = getelementptr i8, ptr %w3, i64 %146
  %scevgep47.i.i = getelementptr i8, ptr %147, i64 8
  %148 = shl i64 %.438.i.i, 3
  %149 = getelementptr i8, ptr %w8, i64 %148
  %scevgep55.i.i = getelementptr i8, ptr %149, i64 8
  br label %B956.i.i

_ZN7msf_jax4host4meso7kernels11merge_ringsB3v62B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx5ArrayIxLi2E1C7mutable7alignedE.exit.i: ; preds = %B902.endif.i.i, %B956.epil.preheader.i.i, %common.ret.loopexit.unr-lcssa.i10.i
  %sunkaddr100.i.i = shl i64 %.155.i.i, 3
  %sunkaddr101.i.i = getelementptr i8, ptr %84, i64 %sunkaddr100.i.i
  store i64 %.510.i.i, ptr %sunkaddr101.i.i, align 8
  %sunkaddr102.i.i = shl i64 %.493.i.i, 3
  %sunkaddr103.i.i = getelementptr i8, ptr %111, i64 %sunkaddr102.i.i
  store i64 0, ptr %sunkaddr103.i.i, align 8
  %.1442.i = icmp slt i64 %count.2.01084.i, 0
  %.1443.i = select i1 %.1442.i, i64 %w39, i64 0
  %.1444.i = add i64 %.1443.i, %count.2.01084.i
  %.1464.i = mul i64 %.1444.i, %w40
  %.1468.i = getelementptr i64, ptr %w38, i64 %.1464.i
  store i64 %one.2.2.i, ptr %.1468.i, align 8
  %.1524.i = getelementptr i8, ptr %.1468.i, i64 8
  store i64 %two.2.2.i, ptr %.1524.i, align 8
  %.1542.i = select i1 %.1442.i, i64 %w42, i64 0
  %150 = getelementptr double, ptr %w41, i64 %count.2.01084.i
  %.1556.i = getelementptr double, ptr %150, i64 %.1542.i
  store double %"$phi438.1.2.2.i", ptr %.1556.i, align 8
  %.269.i.i = select i1 %.1115.i, i64 %w1, i64 0
  %.270.i.i = add i64 %.269.i.i, %one.2.2.i
  %.290.i.i = mul i64 %.270.i.i, %w2
  %151 = getelementptr double, ptr %w0, i64 %.290.i.i
  %.321.i.i = select i1 %.58.i18.i.i, i64 %w1, i64 0
  %.322.i.i = add i64 %.321.i.i, %two.2.2.i
  %.342.i.i = mul i64 %.322.i.i, %w2
  %152 = getelementptr double, ptr %w0, i64 %.342.i.i
  %.295.i.i = load double, ptr %151, align 8
  %.347.i.i = load double, ptr %152, align 8
  %.400.i.i = fsub double %.347.i.i, %.295.i.i
  %.402.i.i = fmul double %"$phi438.1.2.2.i", %.400.i.i
  %.403.i.i = fadd double %.295.i.i, %.402.i.i
  store double %.403.i.i, ptr %151, align 8
  %.294.1.i.i = getelementptr i8, ptr %151, i64 8
  %.295.1.i.i = load double, ptr %.294.1.i.i, align 8
  %.346.1.i.i = getelementptr i8, ptr %152, i64 8
  %.347.1.i.i = load double, ptr %.346.1.i.i, align 8
  %.400.1.i.i = fsub double %.347.1.i.i, %.295.1.i.i
  %.402.1.i.i = fmul double %"$phi438.1.2.2.i", %.400.1.i.i
  %.403.1.i.i = fadd double %.295.1.i.i, %.402.1.i.i
  store double %.403.1.i.i, ptr %.294.1.i.i, align 8
  %.294.2.i.i = getelementptr i8, ptr %151, i64 16
  %.295.2.i.i = load double, ptr %.294.2.i.i, align 8
  %.346.2.i.i = getelementptr i8, ptr %152, i64 16
  %.347.2.i.i = load double, ptr %.346.2.i.i, align 8
  %.400.2.i.i = fsub double %.347.2.i.i, %.295.2.i.i
  %.402.2.i.i = fmul double %"$phi438.1.2.2.i", %.400.2.i.i
  %.403.2.i.i = fadd double %.295.2.i.i, %.402.2.i.i
  store double %.403.2.i.i, ptr %.294.2.i.i, align 8
  %.419.i.i.i = select i1 %.58.i18.i.i, i64 %w15, i64 0
  %153 = getelementptr i8, ptr %w14, i64 %two.2.2.i
  %.433.i.i.i = getelementptr i8, ptr %153, i64 %.419.i.i.i
  %.434.i.i.i = load i8, ptr %.433.i.i.i, align 1
  %.437.i.i.i = icmp eq i8 %.434.i.i.i, 0
  br i1 %.437.i.i.i, label %B150.endif.i.i, label %B156.i.i.i

B733.i:                                           ; preds = %B536.endif.endif.endif.endif.i, %B520.i, %B302.i, %B286.i, %B270.i
  %count.3.1.i = phi i64 [ %count.2.01084.i, %B270.i ], [ %.1759.i, %B536.endif.endif.endif.endif.i ], [ %count.2.01084.i, %B520.i ], [ %count.2.01084.i, %B286.i ], [ %count.2.01084.i, %B302.i ]
  %exitcond.not.i = icmp eq i64 %.292.i, %w26
  br i1 %exitcond.not.i, label %_ZN7msf_jax4host4meso7kernels8collapseB3v58B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE385Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28bool_2c_201d_2c_20C_29_2c_20array_28bool_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEb5ArrayIbLi1E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B58.i

B206.endif.i:                                     ; preds = %B190.i, %B174.i
  %.713.i = icmp slt i64 %.484.i, 0
  %.714.i = select i1 %.713.i, i64 %w7, i64 0
  %154 = getelementptr i64, ptr %w6, i64 %.484.i
  %.728.i = getelementptr i64, ptr %154, i64 %.714.i
  %.729.i = load i64, ptr %.728.i, align 8
  %.746.i = icmp slt i64 %.539.i, 0
  %.747.i = select i1 %.746.i, i64 %w7, i64 0
  %155 = getelementptr i64, ptr %w6, i64 %.539.i
  %.761.i = getelementptr i64, ptr %155, i64 %.747.i
  %.762.i = load i64, ptr %.761.i, align 8
  %.11.i.i = tail call i64 @llvm.smin.i64(i64 %.762.i, i64 %.729.i)
  %.795.i = icmp slt i64 %.11.i.i, 4
  br i1 %.795.i, label %B270.i, label %B286.i

B320.endif.i:                                     ; preds = %B58.epil.i.i, %B88.loopexit.unr-lcssa.i.i, %B320.i
  store i8 1, ptr %.939.i, align 1
  %.88.i171.i = select i1 %.924.i, i64 %w7, i64 0
  %156 = getelementptr i64, ptr %w6, i64 %.429.i
  %.102.i172.i = getelementptr i64, ptr %156, i64 %.88.i171.i
  %.103.i173.i = load i64, ptr %.102.i172.i, align 8
  %.185113.not.i174.i = icmp slt i64 %.103.i173.i, 1
  br i1 %.185113.not.i174.i, label %B320.endif.endif.i, label %B58.lr.ph.i175.i

B58.lr.ph.i175.i:                                 ; preds = %B320.endif.i
  %.247.i176.i = select i1 %.924.i, i64 %w4, i64 0
  %.248.i177.i = add i64 %.247.i176.i, %.429.i
  %xtraiter.i178.i = and i64 %.103.i173.i, 3
  %157 = icmp samesign ult i64 %.103.i173.i, 4
  br i1 %157, label %B58.epil.preheader.i208.i, label %B58.lr.ph.new.i179.i

B58.lr.ph.new.i179.i:                             ; preds = %B58.lr.ph.i175.i
  %unroll_iter.i180.i = and i64 %.103.i173.i, 9223372036854775804
  %158 = mul i64 %.248.i177.i, %s8
  %159 = getelementptr i8, ptr %w3, i64 %158
  %scevgep3.i181.i = getelementptr i8, ptr %159, i64 24
  br label %B58.i182.i

B58.i182.i:                                       ; preds = %B58.i182.i, %B58.lr.ph.new.i179.i
  %.191112114.i183.i = phi i64 [ 0, %B58.lr.ph.new.i179.i ], [ %.198.3.i200.i, %B58.i182.i ]
  %160 = shl i64 %.191112114.i183.i, 3
  %scevgep9.i184.i = getelementptr i8, ptr %scevgep3.i181.i, i64 %160
  %scevgep10.i185.i = getelementptr i8, ptr %scevgep9.i184.i, i64 -24
  %.273.i186.i = load i64, ptr %scevgep10.i185.i, align 8
  %.287.i187.i = icmp slt i64 %.273.i186.i, 0
  %.288.i188.i = select i1 %.287.i187.i, i64 %w32, i64 0
  %161 = getelementptr i8, ptr %w31, i64 %.273.i186.i
  %.302.i189.i = getelementptr i8, ptr %161, i64 %.288.i188.i
  store i8 1, ptr %.302.i189.i, align 1
  %scevgep294.i = getelementptr i8, ptr %scevgep9.i184.i, i64 -16
  %.273.1.i191.i = load i64, ptr %scevgep294.i, align 8
  %.287.1.i192.i = icmp slt i64 %.273.1.i191.i, 0
  %.288.1.i193.i = select i1 %.287.1.i192.i, i64 %w32, i64 0
  %162 = getelementptr i8, ptr %w31, i64 %.273.1.i191.i
  %.302.1.i194.i = getelementptr i8, ptr %162, i64 %.288.1.i193.i
  store i8 1, ptr %.302.1.i194.i, align 1
  %scevgep292.i = getelementptr i8, ptr %scevgep9.i184.i, i64 -8
  %.273.2.i196.i = load i64, ptr %scevgep292.i, align 8
  %.287.2.i197.i = icmp slt i64 %.273.2.i196.i, 0
  %.288.2.i198.i = select i1 %.287.2.i197.i, i64 %w32, i64 0
  %163 = getelementptr i8, ptr %w31, i64 %.273.2.i196.i
  %.302.2.i199.i = getelementptr i8, ptr %163, i64 %.288.2.i198.i
  store i8 1, ptr %.302.2.i199.i, align 1
  %.198.3.i200.i = add nuw nsw i64 %.191112114.i183.i, 4
  %.273.3.i201.i = load i64, ptr %scevgep9.i184.i, align 8
  %.287.3.i202.i = icmp slt i64 %.273.3.i201.i, 0
  %.288.3.i203.i = select i1 %.287.3.i202.i, i64 %w32, i64 0
  %164 = getelementptr i8, ptr %w31, i64 %.273.3.i201.i
  %.302.3.i204.i = getelementptr i8, ptr %164, i64 %.288.3.i203.i
  store i8 1, ptr %.302.3.i204.i, align 1
  %niter.ncmp.3.i205.i = icmp eq i64 %unroll_iter.i180.i, %.198.3.i200.i
  br i1 %niter.ncmp.3.i205.i, label %B88.loopexit.unr-lcssa.i206.i, label %B58.i182.i

B88.loopexit.unr-lcssa.i206.i:                    ; preds = %B58.i182.i
  %lcmp.mod.not.i207.i = icmp eq i64 %xtraiter.i178.i, 0
  br i1 %lcmp.mod.not.i207.i, label %B320.endif.endif.i, label %B58.epil.preheader.i208.i

B58.epil.preheader.i208.i:                        ; preds = %B88.loopexit.unr-lcssa.i206.i, %B58.lr.ph.i175.i
  %.191112114.epil.init.i209.i = phi i64 [ 0, %B58.lr.ph.i175.i ], [ %unroll_iter.i180.i, %B88.loopexit.unr-lcssa.i206.i ]
  %165 = mul i64 %.248.i177.i, %w5
  %166 = add i64 %.191112114.epil.init.i209.i, %165
  %167 = shl i64 %166, 3
  %scevgep.i210.i = getelementptr i8, ptr %w3, i64 %167
  br label %B58.epil.i211.i

B58.epil.i211.i:                                  ; preds = %B58.epil.i211.i, %B58.epil.preheader.i208.i
  %epil.iter.i212.i = phi i64 [ 0, %B58.epil.preheader.i208.i ], [ %epil.iter.next.i218.i, %B58.epil.i211.i ]
  %168 = shl i64 %epil.iter.i212.i, 3
  %scevgep295.i = getelementptr i8, ptr %scevgep.i210.i, i64 %168
  %.273.epil.i214.i = load i64, ptr %scevgep295.i, align 8
  %.287.epil.i215.i = icmp slt i64 %.273.epil.i214.i, 0
  %.288.epil.i216.i = select i1 %.287.epil.i215.i, i64 %w32, i64 0
  %169 = getelementptr i8, ptr %w31, i64 %.273.epil.i214.i
  %.302.epil.i217.i = getelementptr i8, ptr %169, i64 %.288.epil.i216.i
  store i8 1, ptr %.302.epil.i217.i, align 1
  %epil.iter.next.i218.i = add i64 %epil.iter.i212.i, 1
  %epil.iter.cmp.not.i219.i = icmp eq i64 %xtraiter.i178.i, %epil.iter.next.i218.i
  br i1 %epil.iter.cmp.not.i219.i, label %B320.endif.endif.i, label %B58.epil.i211.i

B320.endif.endif.i:                               ; preds = %B58.epil.i211.i, %B88.loopexit.unr-lcssa.i206.i, %B320.endif.i
  %.1060.i = select i1 %.924.i, i64 %w17, i64 0
  %170 = getelementptr i8, ptr %w16, i64 %.429.i
  %.1074.i = getelementptr i8, ptr %170, i64 %.1060.i
  %.1075.i = load i8, ptr %.1074.i, align 1
  %.1078.i = icmp eq i8 %.1075.i, 0
  %one.2.2.i = select i1 %.1078.i, i64 %.374.i, i64 %.429.i
  %two.2.2.i = select i1 %.1078.i, i64 %.429.i, i64 %.374.i
  %.1115.i = icmp slt i64 %one.2.2.i, 0
  %.1116.i = select i1 %.1115.i, i64 %w17, i64 0
  %171 = getelementptr i8, ptr %w16, i64 %one.2.2.i
  %.1130.i = getelementptr i8, ptr %171, i64 %.1116.i
  %.1131.i = load i8, ptr %.1130.i, align 1
  %.1134.i = icmp eq i8 %.1131.i, 0
  %"$phi438.1.2.2.i" = select i1 %.1134.i, double 5.000000e-01, double 0.000000e+00
  br i1 %4, label %B536.i, label %B444.i

B444.endif.endif.i:                               ; preds = %B644.i.i
  br i1 %.1388.i.i, label %B520.i, label %B482.i

B482.endif.endif.i:                               ; preds = %B644.i118.i
  br i1 %.1388.i163.i, label %B520.i, label %B536.i

B156.i.i.i:                                       ; preds = %_ZN7msf_jax4host4meso7kernels11merge_ringsB3v62B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx5ArrayIxLi2E1C7mutable7alignedE.exit.i
  %.156.i.i.i = select i1 %.58.i18.i.i, i64 %w12, i64 0
  %.157.i.i.i = add i64 %.156.i.i.i, %two.2.2.i
  %.177.i.i.i = mul i64 %.157.i.i.i, %w13
  %.181.i.i.i = getelementptr double, ptr %w11, i64 %.177.i.i.i
  %.182.i.i.i = load double, ptr %.181.i.i.i, align 8
  %.238.i.i.i = fsub double %.182.i.i.i, %.403.i.i
  %.147.i.i.i.i = fmul double %.238.i.i.i, %.238.i.i.i
  %.318.i.i.i = getelementptr i8, ptr %.181.i.i.i, i64 8
  %.319.i.i.i = load double, ptr %.318.i.i.i, align 8
  %.375.i.i.i = fsub double %.319.i.i.i, %.403.1.i.i
  %.147.i24.i.i.i = fmul double %.375.i.i.i, %.375.i.i.i
  %.400.i.i.i = fadd double %.147.i.i.i.i, %.147.i24.i.i.i
  %.500.i.i.i = getelementptr i8, ptr %.181.i.i.i, i64 16
  %.501.i.i.i = load double, ptr %.500.i.i.i, align 8
  %.563.i.i.i = fsub double %.501.i.i.i, %.403.2.i.i
  %.147.i12.i.i.i = fmul double %.563.i.i.i, %.563.i.i.i
  %.589.i.i.i = fadd double %.400.i.i.i, %.147.i12.i.i.i
  %sqrt.i.i.i = tail call double @llvm.sqrt.f64(double %.589.i.i.i)
  br label %B150.endif.i.i

common.ret.loopexit.unr-lcssa.i.unr-lcssa.i:      ; preds = %B532.endif.i.i
  br i1 %.not.i, label %B532.endif.i.epil.preheader.i, label %common.ret.loopexit.unr-lcssa.i.i

B532.endif.i.epil.preheader.i:                    ; preds = %B532.endif.lr.ph.new.i.i, %common.ret.loopexit.unr-lcssa.i.unr-lcssa.i
  %.112612631265.i.epil.init.i = phi i64 [ 0, %B532.endif.lr.ph.new.i.i ], [ %.1133.1.i.1.i, %common.ret.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %172 = shl i64 %.112612631265.i.epil.init.i, 3
  %scevgep40.i.epil.i = getelementptr i8, ptr %scevgep.i225.i, i64 %172
  %scevgep41.i.epil.i = getelementptr i8, ptr %scevgep40.i.epil.i, i64 -8
  %.1209.i.epil.i = load double, ptr %scevgep41.i.epil.i, align 8
  %scevgep44.i.epil.i = getelementptr i8, ptr %scevgep42.i.i, i64 %172
  %scevgep45.i.epil.i = getelementptr i8, ptr %scevgep44.i.epil.i, i64 -8
  %.1261.i.epil.i = load double, ptr %scevgep45.i.epil.i, align 8
  %.1262.i.epil.i = fadd double %.1209.i.epil.i, %.1261.i.epil.i
  %.1267.i.epil.i = fmul double %.1262.i.epil.i, 5.000000e-01
  store double %.1267.i.epil.i, ptr %scevgep41.i.epil.i, align 8
  %.1209.1.i.epil.i = load double, ptr %scevgep40.i.epil.i, align 8
  %.1261.1.i.epil.i = load double, ptr %scevgep44.i.epil.i, align 8
  %.1262.1.i.epil.i = fadd double %.1209.1.i.epil.i, %.1261.1.i.epil.i
  %.1267.1.i.epil.i = fmul double %.1262.1.i.epil.i, 5.000000e-01
  store double %.1267.1.i.epil.i, ptr %scevgep40.i.epil.i, align 8
  br label %common.ret.loopexit.unr-lcssa.i.i

common.ret.loopexit.unr-lcssa.i.i:                ; preds = %B532.endif.i.epil.preheader.i, %common.ret.loopexit.unr-lcssa.i.unr-lcssa.i
  br i1 %18, label %B536.endif.endif.endif.i, label %B532.endif.epil.preheader.i.i

B532.endif.epil.preheader.i.i:                    ; preds = %B532.endif.lr.ph.i.i, %common.ret.loopexit.unr-lcssa.i.i
  %gep.i = getelementptr double, ptr %invariant.gep.i, i64 %.1204.i.i
  %.1209.epil.i.i = load double, ptr %gep.i, align 8
  %gep285.i = getelementptr double, ptr %invariant.gep.i, i64 %.1256.i.i
  %.1261.epil.i.i = load double, ptr %gep285.i, align 8
  %.1262.epil.i.i = fadd double %.1209.epil.i.i, %.1261.epil.i.i
  %.1267.epil.i.i = fmul double %.1262.epil.i.i, 5.000000e-01
  store double %.1267.epil.i.i, ptr %gep.i, align 8
  br label %B536.endif.endif.endif.i

B150.endif.i.i:                                   ; preds = %B156.i.i.i, %_ZN7msf_jax4host4meso7kernels11merge_ringsB3v62B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx5ArrayIxLi2E1C7mutable7alignedE.exit.i
  %"$phi248.0.2.0.i.i.i" = phi double [ %sqrt.i.i.i, %B156.i.i.i ], [ 0x7FF0000000000000, %_ZN7msf_jax4host4meso7kernels11merge_ringsB3v62B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx5ArrayIxLi2E1C7mutable7alignedE.exit.i ]
  %.419.i3.i.i = select i1 %.1115.i, i64 %w15, i64 0
  %173 = getelementptr i8, ptr %w14, i64 %one.2.2.i
  %.433.i4.i.i = getelementptr i8, ptr %173, i64 %.419.i3.i.i
  %.434.i5.i.i = load i8, ptr %.433.i4.i.i, align 1
  %.437.i6.i.i = icmp eq i8 %.434.i5.i.i, 0
  br i1 %.437.i6.i.i, label %B150.endif.endif.i.i, label %B156.i7.i.i

B156.i7.i.i:                                      ; preds = %B150.endif.i.i
  %.156.i8.i.i = select i1 %.1115.i, i64 %w12, i64 0
  %.157.i9.i.i = add i64 %.156.i8.i.i, %one.2.2.i
  %.177.i10.i.i = mul i64 %.157.i9.i.i, %w13
  %.181.i11.i.i = getelementptr double, ptr %w11, i64 %.177.i10.i.i
  %.182.i12.i.i = load double, ptr %.181.i11.i.i, align 8
  %.238.i19.i.i = fsub double %.182.i12.i.i, %.403.i.i
  %.147.i.i20.i.i = fmul double %.238.i19.i.i, %.238.i19.i.i
  %.318.i21.i.i = getelementptr i8, ptr %.181.i11.i.i, i64 8
  %.319.i22.i.i = load double, ptr %.318.i21.i.i, align 8
  %.375.i25.i.i = fsub double %.319.i22.i.i, %.403.1.i.i
  %.147.i24.i26.i.i = fmul double %.375.i25.i.i, %.375.i25.i.i
  %.400.i27.i.i = fadd double %.147.i.i20.i.i, %.147.i24.i26.i.i
  %.500.i28.i.i = getelementptr i8, ptr %.181.i11.i.i, i64 16
  %.501.i29.i.i = load double, ptr %.500.i28.i.i, align 8
  %.563.i32.i.i = fsub double %.501.i29.i.i, %.403.2.i.i
  %.147.i12.i33.i.i = fmul double %.563.i32.i.i, %.563.i32.i.i
  %.589.i34.i.i = fadd double %.400.i27.i.i, %.147.i12.i33.i.i
  %sqrt.i35.i.i = tail call double @llvm.sqrt.f64(double %.589.i34.i.i)
  br label %B150.endif.endif.i.i

B150.endif.endif.i.i:                             ; preds = %B156.i7.i.i, %B150.endif.i.i
  %"$phi248.0.2.0.i36.i.i" = phi double [ %sqrt.i35.i.i, %B156.i7.i.i ], [ 0x7FF0000000000000, %B150.endif.i.i ]
  %.574.i.i = fcmp olt double %"$phi248.0.2.0.i.i.i", %"$phi248.0.2.0.i36.i.i"
  br i1 %.574.i.i, label %B226.endif.endif.i.i, label %B376.endif.endif.i.i

B226.endif.endif.i.i:                             ; preds = %B150.endif.endif.i.i
  %.596.i.i = select i1 %.58.i18.i.i, i64 %w19, i64 0
  %174 = getelementptr double, ptr %w18, i64 %two.2.2.i
  %.610.i.i = getelementptr double, ptr %174, i64 %.596.i.i
  %.611.i.i = load double, ptr %.610.i.i, align 8
  store i8 1, ptr %.433.i4.i.i, align 1
  %.661.i.i = select i1 %.1115.i, i64 %w19, i64 0
  %175 = getelementptr double, ptr %w18, i64 %one.2.2.i
  %.675.i.i = getelementptr double, ptr %175, i64 %.661.i.i
  store double %.611.i.i, ptr %.675.i.i, align 8
  %.819.i.i = select i1 %.58.i18.i.i, i64 %w12, i64 0
  %.820.i.i = add i64 %.819.i.i, %two.2.2.i
  %.840.i.i = mul i64 %.820.i.i, %w13
  %176 = getelementptr double, ptr %w11, i64 %.840.i.i
  %.871.i.i = select i1 %.1115.i, i64 %w12, i64 0
  %.872.i.i = add i64 %.871.i.i, %one.2.2.i
  %.892.i.i = mul i64 %.872.i.i, %w13
  %177 = getelementptr double, ptr %w11, i64 %.892.i.i
  %.845.i.i = load double, ptr %176, align 8
  store double %.845.i.i, ptr %177, align 8
  %.844.1.i.i = getelementptr i8, ptr %176, i64 8
  %.845.1.i.i = load double, ptr %.844.1.i.i, align 8
  %.896.1.i.i = getelementptr i8, ptr %177, i64 8
  store double %.845.1.i.i, ptr %.896.1.i.i, align 8
  %.844.2.i.i = getelementptr i8, ptr %176, i64 16
  %.845.2.i.i = load double, ptr %.844.2.i.i, align 8
  %.896.2.i.i = getelementptr i8, ptr %177, i64 16
  store double %.845.2.i.i, ptr %.896.2.i.i, align 8
  br label %B376.endif.endif.i.i

B376.endif.endif.i.i:                             ; preds = %B226.endif.endif.i.i, %B150.endif.endif.i.i
  %.919.i.i = select i1 %.1115.i, i64 %w21, i64 0
  %178 = getelementptr double, ptr %w20, i64 %one.2.2.i
  %.933.i221.i = getelementptr double, ptr %178, i64 %.919.i.i
  %.934.i.i = load double, ptr %.933.i221.i, align 8
  %.951.i.i = select i1 %.58.i18.i.i, i64 %w21, i64 0
  %179 = getelementptr double, ptr %w20, i64 %two.2.2.i
  %.965.i.i = getelementptr double, ptr %179, i64 %.951.i.i
  %.966.i.i = load double, ptr %.965.i.i, align 8
  %.10.i.i.i = fcmp olt double %.966.i.i, %.934.i.i
  %.11.i.i.i = select i1 %.10.i.i.i, double %.966.i.i, double %.934.i.i
  store double %.11.i.i.i, ptr %.933.i221.i, align 8
  br i1 %13, label %B536.endif.endif.endif.i, label %B532.endif.lr.ph.i.i

B532.endif.lr.ph.i.i:                             ; preds = %B376.endif.endif.i.i
  %.1183.i.i = select i1 %.1115.i, i64 %w23, i64 0
  %.1184.i222.i = add i64 %.1183.i.i, %one.2.2.i
  %.1204.i.i = mul i64 %.1184.i222.i, %w24
  %.1235.i.i = select i1 %.58.i18.i.i, i64 %w23, i64 0
  %.1236.i223.i = add i64 %.1235.i.i, %two.2.2.i
  %.1256.i.i = mul i64 %.1236.i223.i, %w24
  br i1 %14, label %B532.endif.epil.preheader.i.i, label %B532.endif.lr.ph.new.i.i

B532.endif.lr.ph.new.i.i:                         ; preds = %B532.endif.lr.ph.i.i
  %180 = shl i64 %.1204.i.i, 3
  %181 = getelementptr i8, ptr %w22, i64 %180
  %scevgep.i225.i = getelementptr i8, ptr %181, i64 8
  %182 = shl i64 %.1256.i.i, 3
  %183 = getelementptr i8, ptr %w22, i64 %182
  %scevgep42.i.i = getelementptr i8, ptr %183, i64 8
  br i1 %15, label %B532.endif.i.epil.preheader.i, label %B532.endif.i.preheader.i

B532.endif.i.preheader.i:                         ; preds = %B532.endif.lr.ph.new.i.i
  %scevgep297.i = getelementptr i8, ptr %scevgep296.i, i64 %180
  %scevgep304.i = getelementptr i8, ptr %scevgep296.i, i64 %182
  br label %B532.endif.i.i

B532.endif.i.i:                                   ; preds = %B532.endif.i.i, %B532.endif.i.preheader.i
  %lsr.iv.i = phi i64 [ %unroll_iter.i, %B532.endif.i.preheader.i ], [ %lsr.iv.next.i, %B532.endif.i.i ]
  %.112612631265.i.i = phi i64 [ 0, %B532.endif.i.preheader.i ], [ %.1133.1.i.1.i, %B532.endif.i.i ]
  %184 = shl i64 %.112612631265.i.i, 3
  %scevgep300.i = getelementptr i8, ptr %scevgep297.i, i64 %184
  %scevgep301.i = getelementptr i8, ptr %scevgep300.i, i64 -16
  %scevgep302.i = getelementptr i8, ptr %scevgep300.i, i64 -24
  %.1209.i.i = load double, ptr %scevgep302.i, align 8
  %scevgep307.i = getelementptr i8, ptr %scevgep304.i, i64 %184
  %scevgep308.i = getelementptr i8, ptr %scevgep307.i, i64 -16
  %scevgep309.i = getelementptr i8, ptr %scevgep307.i, i64 -24
  %.1261.i.i = load double, ptr %scevgep309.i, align 8
  %.1262.i.i = fadd double %.1209.i.i, %.1261.i.i
  %.1267.i.i = fmul double %.1262.i.i, 5.000000e-01
  store double %.1267.i.i, ptr %scevgep302.i, align 8
  %.1209.1.i.i = load double, ptr %scevgep301.i, align 8
  %.1261.1.i.i = load double, ptr %scevgep308.i, align 8
  %.1262.1.i.i = fadd double %.1209.1.i.i, %.1261.1.i.i
  %.1267.1.i.i = fmul double %.1262.1.i.i, 5.000000e-01
  store double %.1267.1.i.i, ptr %scevgep301.i, align 8
  %scevgep299.i = getelementptr i8, ptr %scevgep300.i, i64 -8
  %.1209.i.1.i = load double, ptr %scevgep299.i, align 8
  %scevgep306.i = getelementptr i8, ptr %scevgep307.i, i64 -8
  %.1261.i.1.i = load double, ptr %scevgep306.i, align 8
  %.1262.i.1.i = fadd double %.1209.i.1.i, %.1261.i.1.i
  %.1267.i.1.i = fmul double %.1262.i.1.i, 5.000000e-01
  store double %.1267.i.1.i, ptr %scevgep299.i, align 8
  %.1133.1.i.1.i = add i64 %.112612631265.i.i, 4
  %.1209.1.i.1.i = load double, ptr %scevgep300.i, align 8
  %.1261.1.i.1.i = load double, ptr %scevgep307.i, align 8
  %.1262.1.i.1.i = fadd double %.1209.1.i.1.i, %.1261.1.i.1.i
  %.1267.1.i.1.i = fmul double %.1262.1.i.1.i, 5.000000e-01
  store double %.1267.1.i.1.i, ptr %scevgep300.i, align 8
  %lsr.iv.next.i = add i64 %lsr.iv.i, -2
  %niter.ncmp.1.i = icmp eq i64 %lsr.iv.next.i, 0
  br i1 %niter.ncmp.1.i, label %common.ret.loopexit.unr-lcssa.i.unr-lcssa.i, label %B532.endif.i.i

B536.endif.endif.endif.i:                         ; preds = %B376.endif.endif.i.i, %B532.endif.epil.preheader.i.i, %common.ret.loopexit.unr-lcssa.i.i
  %.1683.i = zext i1 %.574.i.i to i64
  %sunkaddr341.i = shl i64 %.1464.i, 3
  %sunkaddr342.i = getelementptr i8, ptr %w38, i64 %sunkaddr341.i
  %sunkaddr343.i = getelementptr i8, ptr %sunkaddr342.i, i64 16
  store i64 %.1683.i, ptr %sunkaddr343.i, align 8
  %.1700.i = select i1 %.58.i18.i.i, i64 %w34, i64 0
  %185 = getelementptr i8, ptr %w33, i64 %two.2.2.i
  %.1714.i = getelementptr i8, ptr %185, i64 %.1700.i
  store i8 1, ptr %.1714.i, align 1
  %.57.i228.i = select i1 %.1115.i, i64 %w34, i64 0
  %186 = getelementptr i8, ptr %w33, i64 %one.2.2.i
  %.71.i229.i = getelementptr i8, ptr %186, i64 %.57.i228.i
  store i8 1, ptr %.71.i229.i, align 1
  %.103.i232.i = load i64, ptr %.169.i.i, align 8
  %.185113.not.i233.i = icmp slt i64 %.103.i232.i, 1
  br i1 %.185113.not.i233.i, label %B536.endif.endif.endif.endif.i, label %B58.lr.ph.i234.i

B58.lr.ph.i234.i:                                 ; preds = %B536.endif.endif.endif.i
  %xtraiter.i237.i = and i64 %.103.i232.i, 3
  %187 = icmp samesign ult i64 %.103.i232.i, 4
  br i1 %187, label %B58.epil.preheader.i267.i, label %B58.lr.ph.new.i238.i

B58.lr.ph.new.i238.i:                             ; preds = %B58.lr.ph.i234.i
  %unroll_iter.i239.i = and i64 %.103.i232.i, 9223372036854775804
  %188 = mul i64 %.60.i.i.i, %s8
  %189 = getelementptr i8, ptr %w3, i64 %188
  %scevgep3.i240.i = getelementptr i8, ptr %189, i64 24
  br label %B58.i241.i

B58.i241.i:                                       ; preds = %B58.i241.i, %B58.lr.ph.new.i238.i
  %.191112114.i242.i = phi i64 [ 0, %B58.lr.ph.new.i238.i ], [ %.198.3.i259.i, %B58.i241.i ]
  %190 = shl i64 %.191112114.i242.i, 3
  %scevgep9.i243.i = getelementptr i8, ptr %scevgep3.i240.i, i64 %190
  %scevgep10.i244.i = getelementptr i8, ptr %scevgep9.i243.i, i64 -24
  %.273.i245.i = load i64, ptr %scevgep10.i244.i, align 8
  %.287.i246.i = icmp slt i64 %.273.i245.i, 0
  %.288.i247.i = select i1 %.287.i246.i, i64 %w34, i64 0
  %191 = getelementptr i8, ptr %w33, i64 %.273.i245.i
  %.302.i248.i = getelementptr i8, ptr %191, i64 %.288.i247.i
  store i8 1, ptr %.302.i248.i, align 1
  %scevgep313.i = getelementptr i8, ptr %scevgep9.i243.i, i64 -16
  %.273.1.i250.i = load i64, ptr %scevgep313.i, align 8
  %.287.1.i251.i = icmp slt i64 %.273.1.i250.i, 0
  %.288.1.i252.i = select i1 %.287.1.i251.i, i64 %w34, i64 0
  %192 = getelementptr i8, ptr %w33, i64 %.273.1.i250.i
  %.302.1.i253.i = getelementptr i8, ptr %192, i64 %.288.1.i252.i
  store i8 1, ptr %.302.1.i253.i, align 1
  %scevgep311.i = getelementptr i8, ptr %scevgep9.i243.i, i64 -8
  %.273.2.i255.i = load i64, ptr %scevgep311.i, align 8
  %.287.2.i256.i = icmp slt i64 %.273.2.i255.i, 0
  %.288.2.i257.i = select i1 %.287.2.i256.i, i64 %w34, i64 0
  %193 = getelementptr i8, ptr %w33, i64 %.273.2.i255.i
  %.302.2.i258.i = getelementptr i8, ptr %193, i64 %.288.2.i257.i
  store i8 1, ptr %.302.2.i258.i, align 1
  %.198.3.i259.i = add nuw nsw i64 %.191112114.i242.i, 4
  %.273.3.i260.i = load i64, ptr %scevgep9.i243.i, align 8
  %.287.3.i261.i = icmp slt i64 %.273.3.i260.i, 0
  %.288.3.i262.i = select i1 %.287.3.i261.i, i64 %w34, i64 0
  %194 = getelementptr i8, ptr %w33, i64 %.273.3.i260.i
  %.302.3.i263.i = getelementptr i8, ptr %194, i64 %.288.3.i262.i
  store i8 1, ptr %.302.3.i263.i, align 1
  %niter.ncmp.3.i264.i = icmp eq i64 %unroll_iter.i239.i, %.198.3.i259.i
  br i1 %niter.ncmp.3.i264.i, label %B88.loopexit.unr-lcssa.i265.i, label %B58.i241.i

B88.loopexit.unr-lcssa.i265.i:                    ; preds = %B58.i241.i
  %lcmp.mod.not.i266.i = icmp eq i64 %xtraiter.i237.i, 0
  br i1 %lcmp.mod.not.i266.i, label %B536.endif.endif.endif.endif.i, label %B58.epil.preheader.i267.i

B58.epil.preheader.i267.i:                        ; preds = %B88.loopexit.unr-lcssa.i265.i, %B58.lr.ph.i234.i
  %.191112114.epil.init.i268.i = phi i64 [ 0, %B58.lr.ph.i234.i ], [ %unroll_iter.i239.i, %B88.loopexit.unr-lcssa.i265.i ]
  %195 = add i64 %.191112114.epil.init.i268.i, %.80.i.i.i
  %196 = shl i64 %195, 3
  %scevgep.i269.i = getelementptr i8, ptr %w3, i64 %196
  br label %B58.epil.i270.i

B58.epil.i270.i:                                  ; preds = %B58.epil.i270.i, %B58.epil.preheader.i267.i
  %epil.iter.i271.i = phi i64 [ 0, %B58.epil.preheader.i267.i ], [ %epil.iter.next.i277.i, %B58.epil.i270.i ]
  %197 = shl i64 %epil.iter.i271.i, 3
  %scevgep314.i = getelementptr i8, ptr %scevgep.i269.i, i64 %197
  %.273.epil.i273.i = load i64, ptr %scevgep314.i, align 8
  %.287.epil.i274.i = icmp slt i64 %.273.epil.i273.i, 0
  %.288.epil.i275.i = select i1 %.287.epil.i274.i, i64 %w34, i64 0
  %198 = getelementptr i8, ptr %w33, i64 %.273.epil.i273.i
  %.302.epil.i276.i = getelementptr i8, ptr %198, i64 %.288.epil.i275.i
  store i8 1, ptr %.302.epil.i276.i, align 1
  %epil.iter.next.i277.i = add i64 %epil.iter.i271.i, 1
  %epil.iter.cmp.not.i278.i = icmp eq i64 %xtraiter.i237.i, %epil.iter.next.i277.i
  br i1 %epil.iter.cmp.not.i278.i, label %B536.endif.endif.endif.endif.i, label %B58.epil.i270.i

B536.endif.endif.endif.endif.i:                   ; preds = %B58.epil.i270.i, %B88.loopexit.unr-lcssa.i265.i, %B536.endif.endif.endif.i
  %.1759.i = add nsw i64 %count.2.01084.i, 1
  br label %B733.i

_ZN7msf_jax4host4meso7kernels8collapseB3v58B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE385Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28bool_2c_201d_2c_20C_29_2c_20array_28bool_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEb5ArrayIbLi1E1C7mutable7alignedE5ArrayIbLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B733.i, %0
  %count.2.0.lcssa.i = phi i64 [ 0, %0 ], [ %count.3.1.i, %B733.i ]
  ret i64 %count.2.0.lcssa.i
}

define noundef i64 @msf_jax.host.meso.kernels.cut(ptr readonly %words) local_unnamed_addr {
  %w0 = load ptr, ptr %words, align 8
  %p1 = getelementptr i8, ptr %words, i64 8
  %w1 = load i64, ptr %p1, align 8
  %p2 = getelementptr i8, ptr %words, i64 16
  %w2 = load i64, ptr %p2, align 8
  %p3 = getelementptr i8, ptr %words, i64 24
  %w3 = load ptr, ptr %p3, align 8
  %p4 = getelementptr i8, ptr %words, i64 32
  %w4 = load i64, ptr %p4, align 8
  %p5 = getelementptr i8, ptr %words, i64 40
  %w5 = load i64, ptr %p5, align 8
  %s8 = shl i64 %w5, 3
  %p6 = getelementptr i8, ptr %words, i64 48
  %w6 = load ptr, ptr %p6, align 8
  %p7 = getelementptr i8, ptr %words, i64 56
  %w7 = load i64, ptr %p7, align 8
  %p8 = getelementptr i8, ptr %words, i64 64
  %w8 = load ptr, ptr %p8, align 8
  %p9 = getelementptr i8, ptr %words, i64 72
  %w9 = load i64, ptr %p9, align 8
  %p10 = getelementptr i8, ptr %words, i64 80
  %w10 = load i64, ptr %p10, align 8
  %s16 = shl i64 %w10, 3
  %p11 = getelementptr i8, ptr %words, i64 88
  %w11 = load ptr, ptr %p11, align 8
  %p12 = getelementptr i8, ptr %words, i64 96
  %w12 = load i64, ptr %p12, align 8
  %p13 = getelementptr i8, ptr %words, i64 104
  %w13 = load i64, ptr %p13, align 8
  %p20 = getelementptr i8, ptr %words, i64 160
  %w20 = load ptr, ptr %p20, align 8
  %p21 = getelementptr i8, ptr %words, i64 168
  %w21 = load i64, ptr %p21, align 8
  %p23 = getelementptr i8, ptr %words, i64 184
  %w23 = load i64, ptr %p23, align 8
  %p24 = getelementptr i8, ptr %words, i64 192
  %w24 = load i64, ptr %p24, align 8
  %s38 = shl i64 %w24, 3
  %p25 = getelementptr i8, ptr %words, i64 200
  %w25 = load ptr, ptr %p25, align 8
  %p26 = getelementptr i8, ptr %words, i64 208
  %w26 = load i64, ptr %p26, align 8
  %p27 = getelementptr i8, ptr %words, i64 216
  %w27 = load ptr, ptr %p27, align 8
  %p29 = getelementptr i8, ptr %words, i64 232
  %w29 = load ptr, ptr %p29, align 8
  %.2562017.not.i = icmp slt i64 %w26, 1
  br i1 %.2562017.not.i, label %_ZN7msf_jax4host4meso7kernels3cutB3v65B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE385Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28bool_2c_201d_2c_20C_29_2c_20array_28bool_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B106.lr.ph.i

B106.lr.ph.i:                                     ; preds = %0
  %p22 = getelementptr i8, ptr %words, i64 176
  %w22 = load ptr, ptr %p22, align 8
  %.317.i = sub i64 %w4, %w26
  %unroll_iter.i = and i64 %w24, 9223372036854775806
  %scevgep121.i = getelementptr i8, ptr %w22, i64 8
  %1 = icmp slt i64 %w24, 1
  %2 = icmp eq i64 %w24, 1
  %3 = and i64 %w24, 1
  %4 = icmp eq i64 %3, 0
  %invariant.gep.i = getelementptr double, ptr %w22, i64 %unroll_iter.i
  br label %B106.i

B104.loopexit.loopexit.unr-lcssa.i:               ; preds = %B1298.i
  br i1 %4, label %B104.loopexit.i, label %B1298.epil.preheader.i

B1298.epil.preheader.i:                           ; preds = %B1298.lr.ph.i, %B104.loopexit.loopexit.unr-lcssa.i
  %gep.i = getelementptr double, ptr %invariant.gep.i, i64 %.2869.i
  %.2874.epil.i = load double, ptr %gep.i, align 8
  %.2875.epil.i = fmul double %.2257.i, %.2874.epil.i
  %gep2.i = getelementptr double, ptr %invariant.gep.i, i64 %.2922.i
  %.2927.epil.i = load double, ptr %gep2.i, align 8
  %.2929.epil.i = fmul double %.408.i, %.2927.epil.i
  %.2930.epil.i = fadd double %.2875.epil.i, %.2929.epil.i
  %gep4.i = getelementptr double, ptr %invariant.gep.i, i64 %.2977.i
  store double %.2930.epil.i, ptr %gep4.i, align 8
  br label %B104.loopexit.i

B104.loopexit.i:                                  ; preds = %B900.endif.endif.i, %B1298.epil.preheader.i, %B104.loopexit.loopexit.unr-lcssa.i
  %lsr.iv.next133.i = add i64 %lsr.iv132.i, 1
  %exitcond2088.not.i = icmp eq i64 %.269.i, %w26
  br i1 %exitcond2088.not.i, label %_ZN7msf_jax4host4meso7kernels3cutB3v65B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE385Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28bool_2c_201d_2c_20C_29_2c_20array_28bool_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B106.i

B106.i:                                           ; preds = %B104.loopexit.i, %B106.lr.ph.i
  %lsr.iv132.i = phi i64 [ %.317.i, %B106.lr.ph.i ], [ %lsr.iv.next133.i, %B104.loopexit.i ]
  %.26219722026.i = phi i64 [ 0, %B106.lr.ph.i ], [ %.269.i, %B104.loopexit.i ]
  %.269.i = add nuw nsw i64 %.26219722026.i, 1
  %.318.i = add nsw i64 %.26219722026.i, %.317.i
  %5 = getelementptr i64, ptr %w25, i64 %.26219722026.i
  %.348.i = load i64, ptr %5, align 8
  %6 = getelementptr i64, ptr %w27, i64 %.26219722026.i
  %.378.i = load i64, ptr %6, align 8
  %7 = getelementptr double, ptr %w29, i64 %.26219722026.i
  %.408.i = load double, ptr %7, align 8
  %.58.i.i = icmp slt i64 %.348.i, 0
  %.59.i.i = select i1 %.58.i.i, i64 %w4, i64 0
  %.60.i.i = add i64 %.59.i.i, %.348.i
  %.80.i.i = mul i64 %.60.i.i, %w5
  %.84.i.i = getelementptr i64, ptr %w3, i64 %.80.i.i
  %.85.i.i = load i64, ptr %.84.i.i, align 8
  %.87.not.i.i = icmp eq i64 %.85.i.i, %.378.i
  br i1 %.87.not.i.i, label %B106.endif.i, label %B36.preheader.i.i

B36.preheader.i.i:                                ; preds = %B106.i
  %8 = shl i64 %.80.i.i, 3
  %9 = getelementptr i8, ptr %w3, i64 %8
  %scevgep.i.i = getelementptr i8, ptr %9, i64 8
  br label %B36.i.i

B36.i.i:                                          ; preds = %B36.i.i, %B36.preheader.i.i
  %slot.2.0.i.i = phi i64 [ %.90.i.i, %B36.i.i ], [ 0, %B36.preheader.i.i ]
  %.90.i.i = add nuw i64 %slot.2.0.i.i, 1
  %10 = shl i64 %slot.2.0.i.i, 3
  %scevgep1.i.i = getelementptr i8, ptr %scevgep.i.i, i64 %10
  %.145.i.i = load i64, ptr %scevgep1.i.i, align 8
  %.147.not.i.i = icmp eq i64 %.145.i.i, %.378.i
  br i1 %.147.not.i.i, label %B106.endif.i, label %B36.i.i

B730.i:                                           ; preds = %B584.endif.endif.endif.i, %B730.i
  %.162219311933.i = phi i64 [ %.1629.i, %B730.i ], [ %.1535.i, %B584.endif.endif.endif.i ]
  %.1629.i = add i64 %.162219311933.i, -1
  %.1681.i = icmp slt i64 %.162219311933.i, 1
  %11 = select i1 %.1681.i, i64 %s8, i64 0
  %scevgep104.i = getelementptr i8, ptr %.84.i63.i, i64 %11
  %12 = shl i64 %.162219311933.i, 3
  %scevgep105.i = getelementptr i8, ptr %scevgep104.i, i64 %12
  %scevgep106.i = getelementptr i8, ptr %scevgep105.i, i64 -8
  %.1705.i = load i64, ptr %scevgep106.i, align 8
  %13 = select i1 %.1681.i, i64 %s16, i64 0
  %scevgep107.i = getelementptr i8, ptr %71, i64 %13
  %scevgep108.i = getelementptr i8, ptr %scevgep107.i, i64 %12
  %scevgep109.i = getelementptr i8, ptr %scevgep108.i, i64 -8
  %.1757.i = load i64, ptr %scevgep109.i, align 8
  %.1784.i = icmp slt i64 %.162219311933.i, 0
  %14 = select i1 %.1784.i, i64 %s8, i64 0
  %scevgep102.i = getelementptr i8, ptr %.84.i63.i, i64 %14
  %scevgep103.i = getelementptr i8, ptr %scevgep102.i, i64 %12
  store i64 %.1705.i, ptr %scevgep103.i, align 8
  %15 = select i1 %.1784.i, i64 %s16, i64 0
  %scevgep.i = getelementptr i8, ptr %71, i64 %15
  %scevgep101.i = getelementptr i8, ptr %scevgep.i, i64 %12
  store i64 %.1757.i, ptr %scevgep101.i, align 8
  %16 = sub i64 %.1629.i, %slot.3.1.i74.i
  %.1616.i = icmp samesign ugt i64 %16, 1
  br i1 %.1616.i, label %B730.i, label %B808.i

B808.i:                                           ; preds = %B730.i, %B584.endif.endif.endif.i
  %.1866.i = sub i64 0, %.1501.i
  %.1895.i = icmp slt i64 %slot.3.1.i74.i, -1
  %.1896.i = select i1 %.1895.i, i64 %w5, i64 0
  %17 = getelementptr i64, ptr %.84.i63.i, i64 %.1415.i
  %.1918.i = getelementptr i64, ptr %17, i64 %.1896.i
  store i64 %.318.i, ptr %.1918.i, align 8
  %.1951.i = select i1 %.1895.i, i64 %w10, i64 0
  %18 = getelementptr i64, ptr %71, i64 %.1415.i
  %.1973.i = getelementptr i64, ptr %18, i64 %.1951.i
  store i64 %.1501.i, ptr %.1973.i, align 8
  %sunkaddr.i = shl i64 %.1077.i, 3
  %sunkaddr138.i = getelementptr i8, ptr %w8, i64 %sunkaddr.i
  %sunkaddr139.i = getelementptr i8, ptr %sunkaddr138.i, i64 8
  store i64 %.1866.i, ptr %sunkaddr139.i, align 8
  %sunkaddr140.i = shl i64 %.1520.i, 3
  %sunkaddr141.i = getelementptr inbounds i8, ptr %73, i64 %sunkaddr140.i
  %.2063.i = load i64, ptr %sunkaddr141.i, align 8
  %.2064.i = add nsw i64 %.2063.i, 1
  store i64 %.2064.i, ptr %sunkaddr141.i, align 8
  %.58.i8.i = icmp slt i64 %.738.i, 0
  %.59.i9.i = select i1 %.58.i8.i, i64 %w4, i64 0
  %.60.i10.i = add i64 %.59.i9.i, %.738.i
  %.80.i11.i = mul i64 %.60.i10.i, %w5
  %.84.i12.i = getelementptr i64, ptr %w3, i64 %.80.i11.i
  %.85.i13.i = load i64, ptr %.84.i12.i, align 8
  %.87.not.i14.i = icmp eq i64 %.85.i13.i, %.378.i
  br i1 %.87.not.i14.i, label %B584.endif.endif.endif.1.i, label %B36.preheader.i15.i

B36.preheader.i15.i:                              ; preds = %B808.i
  %19 = shl i64 %.80.i11.i, 3
  %20 = getelementptr i8, ptr %w3, i64 %19
  br label %B36.i17.i

B36.i17.i:                                        ; preds = %B36.i17.i, %B36.preheader.i15.i
  %lsr.iv.i = phi i64 [ %lsr.iv.next.i, %B36.i17.i ], [ 1, %B36.preheader.i15.i ]
  %21 = shl i64 %lsr.iv.i, 3
  %scevgep110.i = getelementptr i8, ptr %20, i64 %21
  %.145.i21.i = load i64, ptr %scevgep110.i, align 8
  %.147.not.i22.i = icmp eq i64 %.145.i21.i, %.378.i
  %lsr.iv.next.i = add nuw i64 %lsr.iv.i, 1
  br i1 %.147.not.i22.i, label %B36.i34.i, label %B36.i17.i

B36.i34.i:                                        ; preds = %B36.i17.i, %B36.i34.i
  %slot.2.0.i35.i = phi i64 [ %.90.i36.i, %B36.i34.i ], [ 0, %B36.i17.i ]
  %.90.i36.i = add nuw i64 %slot.2.0.i35.i, 1
  %sunkaddr142.i = shl i64 %slot.2.0.i35.i, 3
  %sunkaddr143.i = getelementptr i8, ptr %20, i64 %sunkaddr142.i
  %sunkaddr144.i = getelementptr i8, ptr %sunkaddr143.i, i64 8
  %.145.i38.i = load i64, ptr %sunkaddr144.i, align 8
  %.147.not.i39.i = icmp eq i64 %.145.i38.i, %.378.i
  br i1 %.147.not.i39.i, label %B584.endif.endif.endif.1.i, label %B36.i34.i

B584.endif.endif.endif.1.i:                       ; preds = %B36.i34.i, %B808.i
  %.1415.198.i = phi i64 [ 1, %B808.i ], [ %lsr.iv.next.i, %B36.i34.i ]
  %slot.3.1.i40.i = phi i64 [ 0, %B808.i ], [ %.90.i36.i, %B36.i34.i ]
  %.1475.1.i = select i1 %.58.i8.i, i64 %w9, i64 0
  %.1476.1.i = add i64 %.1475.1.i, %.738.i
  %.1496.1.i = mul i64 %.1476.1.i, %w10
  %22 = getelementptr i64, ptr %w8, i64 %.1496.1.i
  %23 = getelementptr i64, ptr %22, i64 %slot.3.1.i40.i
  %.1501.1.i = load i64, ptr %23, align 8
  %.1520.1.i = select i1 %.58.i8.i, i64 %w7, i64 0
  %24 = getelementptr i64, ptr %w6, i64 %.738.i
  %.1534.1.i = getelementptr i64, ptr %24, i64 %.1520.1.i
  %.1535.1.i = load i64, ptr %.1534.1.i, align 8
  %.1573.1.i = sub i64 %.1415.198.i, %.1535.1.i
  %.16161932.12120.i = icmp ugt i64 %.1573.1.i, -9223372036854775808
  br i1 %.16161932.12120.i, label %B730.1.i, label %B900.endif.endif.i

B730.1.i:                                         ; preds = %B584.endif.endif.endif.1.i, %B730.1.i
  %.162219311933.1.i = phi i64 [ %.1629.1.i, %B730.1.i ], [ %.1535.1.i, %B584.endif.endif.endif.1.i ]
  %.1629.1.i = add i64 %.162219311933.1.i, -1
  %.1681.1.i = icmp slt i64 %.162219311933.1.i, 1
  %25 = select i1 %.1681.1.i, i64 %s8, i64 0
  %scevgep115.i = getelementptr i8, ptr %.84.i12.i, i64 %25
  %26 = shl i64 %.162219311933.1.i, 3
  %scevgep116.i = getelementptr i8, ptr %scevgep115.i, i64 %26
  %scevgep117.i = getelementptr i8, ptr %scevgep116.i, i64 -8
  %.1705.1.i = load i64, ptr %scevgep117.i, align 8
  %27 = select i1 %.1681.1.i, i64 %s16, i64 0
  %scevgep118.i = getelementptr i8, ptr %22, i64 %27
  %scevgep119.i = getelementptr i8, ptr %scevgep118.i, i64 %26
  %scevgep120.i = getelementptr i8, ptr %scevgep119.i, i64 -8
  %.1757.1.i = load i64, ptr %scevgep120.i, align 8
  %.1784.1.i = icmp slt i64 %.162219311933.1.i, 0
  %28 = select i1 %.1784.1.i, i64 %s8, i64 0
  %scevgep113.i = getelementptr i8, ptr %.84.i12.i, i64 %28
  %scevgep114.i = getelementptr i8, ptr %scevgep113.i, i64 %26
  store i64 %.1705.1.i, ptr %scevgep114.i, align 8
  %29 = select i1 %.1784.1.i, i64 %s16, i64 0
  %scevgep111.i = getelementptr i8, ptr %22, i64 %29
  %scevgep112.i = getelementptr i8, ptr %scevgep111.i, i64 %26
  store i64 %.1757.1.i, ptr %scevgep112.i, align 8
  %30 = sub i64 %.162219311933.1.i, %.1415.198.i
  %.1616.1.i = icmp samesign ugt i64 %30, 1
  br i1 %.1616.1.i, label %B730.1.i, label %B900.endif.endif.i

B1298.i:                                          ; preds = %B1298.preheader.i, %B1298.i
  %.278819621964.i = phi i64 [ %.2795.1.i, %B1298.i ], [ 0, %B1298.preheader.i ]
  %31 = shl i64 %.278819621964.i, 3
  %scevgep124.i = getelementptr i8, ptr %scevgep122.i, i64 %31
  %scevgep125.i = getelementptr i8, ptr %scevgep124.i, i64 -8
  %.2874.i = load double, ptr %scevgep125.i, align 8
  %.2875.i = fmul double %.2257.i, %.2874.i
  %scevgep129.i = getelementptr i8, ptr %scevgep127.i, i64 %31
  %scevgep130.i = getelementptr i8, ptr %scevgep129.i, i64 -8
  %.2927.i = load double, ptr %scevgep130.i, align 8
  %.2929.i = fmul double %.408.i, %.2927.i
  %.2930.i = fadd double %.2875.i, %.2929.i
  %scevgep136.i = getelementptr i8, ptr %scevgep134.i, i64 %31
  %scevgep137.i = getelementptr i8, ptr %scevgep136.i, i64 -8
  store double %.2930.i, ptr %scevgep137.i, align 8
  %.2795.1.i = add nuw i64 %.278819621964.i, 2
  %.2874.1.i = load double, ptr %scevgep124.i, align 8
  %.2875.1.i = fmul double %.2257.i, %.2874.1.i
  %.2927.1.i = load double, ptr %scevgep129.i, align 8
  %.2929.1.i = fmul double %.408.i, %.2927.1.i
  %.2930.1.i = fadd double %.2875.1.i, %.2929.1.i
  store double %.2930.1.i, ptr %scevgep136.i, align 8
  %niter.ncmp.1.i = icmp eq i64 %unroll_iter.i, %.2795.1.i
  br i1 %niter.ncmp.1.i, label %B104.loopexit.loopexit.unr-lcssa.i, label %B1298.i

B106.endif.i:                                     ; preds = %B36.i.i, %B106.i
  %slot.3.1.i.i = phi i64 [ 0, %B106.i ], [ %.90.i.i, %B36.i.i ]
  %.58.i42.i = icmp slt i64 %.378.i, 0
  %.59.i43.i = select i1 %.58.i42.i, i64 %w4, i64 0
  %.60.i44.i = add i64 %.59.i43.i, %.378.i
  %.80.i45.i = mul i64 %.60.i44.i, %w5
  %.84.i46.i = getelementptr i64, ptr %w3, i64 %.80.i45.i
  %.85.i47.i = load i64, ptr %.84.i46.i, align 8
  %.87.not.i48.i = icmp eq i64 %.85.i47.i, %.348.i
  br i1 %.87.not.i48.i, label %B106.endif.endif.i, label %B36.preheader.i49.i

B36.preheader.i49.i:                              ; preds = %B106.endif.i
  %32 = shl i64 %.80.i45.i, 3
  %33 = getelementptr i8, ptr %w3, i64 %32
  %scevgep.i50.i = getelementptr i8, ptr %33, i64 8
  br label %B36.i51.i

B36.i51.i:                                        ; preds = %B36.i51.i, %B36.preheader.i49.i
  %slot.2.0.i52.i = phi i64 [ %.90.i53.i, %B36.i51.i ], [ 0, %B36.preheader.i49.i ]
  %.90.i53.i = add nuw i64 %slot.2.0.i52.i, 1
  %34 = shl i64 %slot.2.0.i52.i, 3
  %scevgep1.i54.i = getelementptr i8, ptr %scevgep.i50.i, i64 %34
  %.145.i55.i = load i64, ptr %scevgep1.i54.i, align 8
  %.147.not.i56.i = icmp eq i64 %.145.i55.i, %.348.i
  br i1 %.147.not.i56.i, label %B106.endif.endif.i, label %B36.i51.i

B106.endif.endif.i:                               ; preds = %B36.i51.i, %B106.endif.i
  %slot.3.1.i57.i = phi i64 [ 0, %B106.endif.i ], [ %.90.i53.i, %B36.i51.i ]
  %.509.i = select i1 %.58.i.i, i64 %w7, i64 0
  %35 = getelementptr i64, ptr %w6, i64 %.348.i
  %.523.i = getelementptr i64, ptr %35, i64 %.509.i
  %.524.i = load i64, ptr %.523.i, align 8
  %.527.i = icmp eq i64 %.524.i, 0
  br i1 %.527.i, label %B556.lr.ph.i, label %B106.endif.endif.endif.i

B106.endif.endif.endif.i:                         ; preds = %B106.endif.endif.i
  %.493.i = add nsw i64 %slot.3.1.i.i, 1
  %36 = or i64 %.524.i, %.493.i
  %37 = icmp ult i64 %36, 4294967296
  br i1 %37, label %38, label %43

38:                                               ; preds = %B106.endif.endif.endif.i
  %39 = trunc nuw i64 %.524.i to i32
  %40 = trunc nuw i64 %.493.i to i32
  %41 = urem i32 %40, %39
  %42 = zext i32 %41 to i64
  br label %45

43:                                               ; preds = %B106.endif.endif.endif.i
  %44 = srem i64 %.493.i, %.524.i
  br label %45

45:                                               ; preds = %43, %38
  %46 = phi i64 [ %42, %38 ], [ %44, %43 ]
  %.545.i = xor i64 %46, %.524.i
  %.546.i = icmp slt i64 %.545.i, 0
  %.547.i = icmp ne i64 %46, 0
  %.548.i = and i1 %.547.i, %.546.i
  %.555.i = select i1 %.548.i, i64 %.524.i, i64 0
  %spec.select.i = add i64 %.555.i, %46
  %spec.select.fr.i = freeze i64 %spec.select.i
  %.591.i = icmp slt i64 %spec.select.fr.i, 0
  %spec.select2118.i = select i1 %.591.i, i64 %w5, i64 0
  %47 = getelementptr i64, ptr %.84.i.i, i64 %spec.select.fr.i
  %.6142105.i = getelementptr i64, ptr %47, i64 %spec.select2118.i
  %.6152106.i = load i64, ptr %.6142105.i, align 8
  %.6162107.i = add nsw i64 %slot.3.1.i.i, -1
  %.661.i = icmp ne i64 %.6162107.i, -9223372036854775808
  %.662.i = icmp ne i64 %.524.i, -1
  %.663.not.i = or i1 %.661.i, %.662.i
  br i1 %.663.not.i, label %B106.endif.endif.endif.else.if.i, label %B556.lr.ph.i

B106.endif.endif.endif.else.if.i:                 ; preds = %45
  %48 = or i64 %.524.i, %.6162107.i
  %49 = icmp ult i64 %48, 4294967296
  br i1 %49, label %50, label %55

50:                                               ; preds = %B106.endif.endif.endif.else.if.i
  %51 = trunc nuw i64 %.524.i to i32
  %52 = trunc nuw i64 %.6162107.i to i32
  %53 = urem i32 %52, %51
  %54 = zext i32 %53 to i64
  br label %57

55:                                               ; preds = %B106.endif.endif.endif.else.if.i
  %56 = srem i64 %.6162107.i, %.524.i
  br label %57

57:                                               ; preds = %55, %50
  %58 = phi i64 [ %54, %50 ], [ %56, %55 ]
  %.668.i = xor i64 %58, %.524.i
  %.669.i = icmp slt i64 %.668.i, 0
  %.670.i = icmp ne i64 %58, 0
  %.671.i = and i1 %.670.i, %.669.i
  %.678.i = select i1 %.671.i, i64 %.524.i, i64 0
  %spec.select1920.i = add i64 %.678.i, %58
  %spec.select1920.fr.i = freeze i64 %spec.select1920.i
  %.714.i = icmp slt i64 %spec.select1920.fr.i, 0
  %.715.i = select i1 %.714.i, i64 %w5, i64 0
  %59 = getelementptr i64, ptr %.84.i.i, i64 %.715.i
  %.737.phi.trans.insert.i = getelementptr i64, ptr %59, i64 %spec.select1920.fr.i
  %.738.pre.i = load i64, ptr %.737.phi.trans.insert.i, align 8
  br label %B556.lr.ph.i

B556.lr.ph.i:                                     ; preds = %57, %45, %B106.endif.endif.i
  %.738.i = phi i64 [ %.85.i.i, %45 ], [ %.738.pre.i, %57 ], [ %.85.i.i, %B106.endif.endif.i ]
  %.6152109.i = phi i64 [ %.6152106.i, %45 ], [ %.6152106.i, %57 ], [ %.85.i.i, %B106.endif.endif.i ]
  %.784.i = icmp slt i64 %.318.i, 0
  %.785.i = select i1 %.784.i, i64 %w4, i64 0
  %.786.i = add i64 %.785.i, %.318.i
  %.806.i = mul i64 %.786.i, %w5
  %.810.i = getelementptr i64, ptr %w3, i64 %.806.i
  store i64 %.378.i, ptr %.810.i, align 8
  %.865.i = getelementptr i8, ptr %.810.i, i64 8
  store i64 %.6152109.i, ptr %.865.i, align 8
  %.920.i = getelementptr i8, ptr %.810.i, i64 16
  store i64 %.348.i, ptr %.920.i, align 8
  %.975.i = getelementptr i8, ptr %.810.i, i64 24
  store i64 %.738.i, ptr %.975.i, align 8
  %.1001.i = select i1 %.58.i42.i, i64 %w9, i64 0
  %.1002.i = add i64 %.1001.i, %.378.i
  %.1022.i = mul i64 %.1002.i, %w10
  %60 = getelementptr i64, ptr %w8, i64 %.1022.i
  %61 = getelementptr i64, ptr %60, i64 %slot.3.1.i57.i
  %.1027.i = load i64, ptr %61, align 8
  %.1056.i = select i1 %.784.i, i64 %w9, i64 0
  %.1057.i = add i64 %.1056.i, %.318.i
  %.1077.i = mul i64 %.1057.i, %w10
  %62 = getelementptr i64, ptr %w8, i64 %.1077.i
  %.1081.i = getelementptr i8, ptr %62, i64 16
  store i64 %.1027.i, ptr %.1081.i, align 8
  store i64 0, ptr %61, align 8
  %63 = getelementptr i64, ptr %.84.i.i, i64 %slot.3.1.i.i
  store i64 %.318.i, ptr %63, align 8
  %64 = getelementptr i64, ptr %.84.i46.i, i64 %slot.3.1.i57.i
  store i64 %.318.i, ptr %64, align 8
  %.58.i59.i = icmp slt i64 %.6152109.i, 0
  %.59.i60.i = select i1 %.58.i59.i, i64 %w4, i64 0
  %.60.i61.i = add i64 %.59.i60.i, %.6152109.i
  %.80.i62.i = mul i64 %.60.i61.i, %w5
  %.84.i63.i = getelementptr i64, ptr %w3, i64 %.80.i62.i
  %.85.i64.i = load i64, ptr %.84.i63.i, align 8
  %.87.not.i65.i = icmp eq i64 %.85.i64.i, %.348.i
  br i1 %.87.not.i65.i, label %B584.endif.i, label %B36.preheader.i66.i

B36.preheader.i66.i:                              ; preds = %B556.lr.ph.i
  %65 = shl i64 %.80.i62.i, 3
  %66 = getelementptr i8, ptr %w3, i64 %65
  %scevgep.i67.i = getelementptr i8, ptr %66, i64 8
  br label %B36.i68.i

B36.i68.i:                                        ; preds = %B36.i68.i, %B36.preheader.i66.i
  %slot.2.0.i69.i = phi i64 [ %.90.i70.i, %B36.i68.i ], [ 0, %B36.preheader.i66.i ]
  %.90.i70.i = add nuw i64 %slot.2.0.i69.i, 1
  %67 = shl i64 %slot.2.0.i69.i, 3
  %scevgep1.i71.i = getelementptr i8, ptr %scevgep.i67.i, i64 %67
  %.145.i72.i = load i64, ptr %scevgep1.i71.i, align 8
  %.147.not.i73.i = icmp eq i64 %.145.i72.i, %.348.i
  br i1 %.147.not.i73.i, label %B584.endif.i, label %B36.i68.i

B584.endif.i:                                     ; preds = %B36.i68.i, %B556.lr.ph.i
  %slot.3.1.i74.i = phi i64 [ 0, %B556.lr.ph.i ], [ %.90.i70.i, %B36.i68.i ]
  %.1415.i = add nsw i64 %slot.3.1.i74.i, 1
  %.87.not.i82.i = icmp eq i64 %.85.i64.i, %.378.i
  br i1 %.87.not.i82.i, label %B584.endif.endif.endif.i, label %B36.preheader.i83.i

B36.preheader.i83.i:                              ; preds = %B584.endif.i
  %68 = shl i64 %.80.i62.i, 3
  %69 = getelementptr i8, ptr %w3, i64 %68
  %scevgep.i84.i = getelementptr i8, ptr %69, i64 8
  br label %B36.i85.i

B36.i85.i:                                        ; preds = %B36.i85.i, %B36.preheader.i83.i
  %slot.2.0.i86.i = phi i64 [ %.90.i87.i, %B36.i85.i ], [ 0, %B36.preheader.i83.i ]
  %.90.i87.i = add nuw i64 %slot.2.0.i86.i, 1
  %70 = shl i64 %slot.2.0.i86.i, 3
  %scevgep1.i88.i = getelementptr i8, ptr %scevgep.i84.i, i64 %70
  %.145.i89.i = load i64, ptr %scevgep1.i88.i, align 8
  %.147.not.i90.i = icmp eq i64 %.145.i89.i, %.378.i
  br i1 %.147.not.i90.i, label %B584.endif.endif.endif.i, label %B36.i85.i

B584.endif.endif.endif.i:                         ; preds = %B36.i85.i, %B584.endif.i
  %slot.3.1.i91.i = phi i64 [ 0, %B584.endif.i ], [ %.90.i87.i, %B36.i85.i ]
  %.1475.i = select i1 %.58.i59.i, i64 %w9, i64 0
  %.1476.i = add i64 %.1475.i, %.6152109.i
  %.1496.i = mul i64 %.1476.i, %w10
  %71 = getelementptr i64, ptr %w8, i64 %.1496.i
  %72 = getelementptr i64, ptr %71, i64 %slot.3.1.i91.i
  %.1501.i = load i64, ptr %72, align 8
  %.1520.i = select i1 %.58.i59.i, i64 %w7, i64 0
  %73 = getelementptr i64, ptr %w6, i64 %.6152109.i
  %.1534.i = getelementptr i64, ptr %73, i64 %.1520.i
  %.1535.i = load i64, ptr %.1534.i, align 8
  %.1573.i = sub i64 %.1415.i, %.1535.i
  %.161619322119.i = icmp ugt i64 %.1573.i, -9223372036854775808
  br i1 %.161619322119.i, label %B730.i, label %B808.i

B900.endif.endif.i:                               ; preds = %B730.1.i, %B584.endif.endif.endif.1.i
  %.1866.1.i = sub i64 0, %.1501.1.i
  %74 = getelementptr i64, ptr %.84.i12.i, i64 %.1415.198.i
  store i64 %.318.i, ptr %74, align 8
  %75 = getelementptr i64, ptr %22, i64 %.1415.198.i
  store i64 %.1501.1.i, ptr %75, align 8
  %sunkaddr147.i = getelementptr i8, ptr %sunkaddr138.i, i64 24
  store i64 %.1866.1.i, ptr %sunkaddr147.i, align 8
  %sunkaddr148.i = shl i64 %.1520.1.i, 3
  %sunkaddr149.i = getelementptr inbounds i8, ptr %24, i64 %sunkaddr148.i
  %.2063.1.i = load i64, ptr %sunkaddr149.i, align 8
  %.2064.1.i = add nsw i64 %.2063.1.i, 1
  store i64 %.2064.1.i, ptr %sunkaddr149.i, align 8
  %.2122.i = select i1 %.784.i, i64 %w7, i64 0
  %76 = getelementptr i64, ptr %w6, i64 %.318.i
  %.2136.i = getelementptr i64, ptr %76, i64 %.2122.i
  store i64 4, ptr %.2136.i, align 8
  %.2257.i = fsub double 1.000000e+00, %.408.i
  %.2283.i = select i1 %.58.i.i, i64 %w1, i64 0
  %.2284.i = add i64 %.2283.i, %.348.i
  %.2304.i = mul i64 %.2284.i, %w2
  %77 = getelementptr double, ptr %w0, i64 %.2304.i
  %.2336.i = select i1 %.58.i42.i, i64 %w1, i64 0
  %.2337.i = add i64 %.2336.i, %.378.i
  %.2357.i = mul i64 %.2337.i, %w2
  %78 = getelementptr double, ptr %w0, i64 %.2357.i
  %.2391.i = select i1 %.784.i, i64 %w1, i64 0
  %.2392.i = add i64 %.2391.i, %.318.i
  %.2412.i = mul i64 %.2392.i, %w2
  %79 = getelementptr double, ptr %w0, i64 %.2412.i
  %.2446.i = select i1 %.58.i.i, i64 %w12, i64 0
  %.2447.i = add i64 %.2446.i, %.348.i
  %.2467.i = mul i64 %.2447.i, %w13
  %80 = getelementptr double, ptr %w11, i64 %.2467.i
  %.2499.i = select i1 %.58.i42.i, i64 %w12, i64 0
  %.2500.i = add i64 %.2499.i, %.378.i
  %.2520.i = mul i64 %.2500.i, %w13
  %81 = getelementptr double, ptr %w11, i64 %.2520.i
  %.2554.i = select i1 %.784.i, i64 %w12, i64 0
  %.2555.i = add i64 %.2554.i, %.318.i
  %.2575.i = mul i64 %.2555.i, %w13
  %82 = getelementptr double, ptr %w11, i64 %.2575.i
  %.2309.i = load double, ptr %77, align 8
  %.2310.i = fmul double %.2257.i, %.2309.i
  %.2362.i = load double, ptr %78, align 8
  %.2364.i = fmul double %.408.i, %.2362.i
  %.2365.i = fadd double %.2310.i, %.2364.i
  store double %.2365.i, ptr %79, align 8
  %.2472.i = load double, ptr %80, align 8
  %.2473.i = fmul double %.2257.i, %.2472.i
  %.2525.i = load double, ptr %81, align 8
  %.2527.i = fmul double %.408.i, %.2525.i
  %.2528.i = fadd double %.2473.i, %.2527.i
  store double %.2528.i, ptr %82, align 8
  %.2308.1.i = getelementptr i8, ptr %77, i64 8
  %.2309.1.i = load double, ptr %.2308.1.i, align 8
  %.2310.1.i = fmul double %.2257.i, %.2309.1.i
  %.2361.1.i = getelementptr i8, ptr %78, i64 8
  %.2362.1.i = load double, ptr %.2361.1.i, align 8
  %.2364.1.i = fmul double %.408.i, %.2362.1.i
  %.2365.1.i = fadd double %.2310.1.i, %.2364.1.i
  %.2416.1.i = getelementptr i8, ptr %79, i64 8
  store double %.2365.1.i, ptr %.2416.1.i, align 8
  %.2471.1.i = getelementptr i8, ptr %80, i64 8
  %.2472.1.i = load double, ptr %.2471.1.i, align 8
  %.2473.1.i = fmul double %.2257.i, %.2472.1.i
  %.2524.1.i = getelementptr i8, ptr %81, i64 8
  %.2525.1.i = load double, ptr %.2524.1.i, align 8
  %.2527.1.i = fmul double %.408.i, %.2525.1.i
  %.2528.1.i = fadd double %.2473.1.i, %.2527.1.i
  %.2579.1.i = getelementptr i8, ptr %82, i64 8
  store double %.2528.1.i, ptr %.2579.1.i, align 8
  %.2308.2.i = getelementptr i8, ptr %77, i64 16
  %.2309.2.i = load double, ptr %.2308.2.i, align 8
  %.2310.2.i = fmul double %.2257.i, %.2309.2.i
  %.2361.2.i = getelementptr i8, ptr %78, i64 16
  %.2362.2.i = load double, ptr %.2361.2.i, align 8
  %.2364.2.i = fmul double %.408.i, %.2362.2.i
  %.2365.2.i = fadd double %.2310.2.i, %.2364.2.i
  %.2416.2.i = getelementptr i8, ptr %79, i64 16
  store double %.2365.2.i, ptr %.2416.2.i, align 8
  %.2471.2.i = getelementptr i8, ptr %80, i64 16
  %.2472.2.i = load double, ptr %.2471.2.i, align 8
  %.2473.2.i = fmul double %.2257.i, %.2472.2.i
  %.2524.2.i = getelementptr i8, ptr %81, i64 16
  %.2525.2.i = load double, ptr %.2524.2.i, align 8
  %.2527.2.i = fmul double %.408.i, %.2525.2.i
  %.2528.2.i = fadd double %.2473.2.i, %.2527.2.i
  %.2579.2.i = getelementptr i8, ptr %82, i64 16
  store double %.2528.2.i, ptr %.2579.2.i, align 8
  %.2605.i = select i1 %.58.i.i, i64 %w21, i64 0
  %83 = getelementptr double, ptr %w20, i64 %.348.i
  %.2619.i = getelementptr double, ptr %83, i64 %.2605.i
  %.2620.i = load double, ptr %.2619.i, align 8
  %.2621.i = fmul double %.2257.i, %.2620.i
  %.2638.i = select i1 %.58.i42.i, i64 %w21, i64 0
  %84 = getelementptr double, ptr %w20, i64 %.378.i
  %.2652.i = getelementptr double, ptr %84, i64 %.2638.i
  %.2653.i = load double, ptr %.2652.i, align 8
  %.2655.i = fmul double %.408.i, %.2653.i
  %.2656.i = fadd double %.2621.i, %.2655.i
  %.2673.i = select i1 %.784.i, i64 %w21, i64 0
  %85 = getelementptr double, ptr %w20, i64 %.318.i
  %.2687.i = getelementptr double, ptr %85, i64 %.2673.i
  store double %.2656.i, ptr %.2687.i, align 8
  br i1 %1, label %B104.loopexit.i, label %B1298.lr.ph.i

B1298.lr.ph.i:                                    ; preds = %B900.endif.endif.i
  %.2848.i = select i1 %.58.i.i, i64 %w23, i64 0
  %.2849.i = add i64 %.2848.i, %.348.i
  %.2869.i = mul i64 %.2849.i, %w24
  %.2901.i = select i1 %.58.i42.i, i64 %w23, i64 0
  %.2902.i = add i64 %.2901.i, %.378.i
  %.2922.i = mul i64 %.2902.i, %w24
  %.2956.i = select i1 %.784.i, i64 %w23, i64 0
  %.2957.i = add i64 %.2956.i, %.318.i
  %.2977.i = mul i64 %.2957.i, %w24
  br i1 %2, label %B1298.epil.preheader.i, label %B1298.preheader.i

B1298.preheader.i:                                ; preds = %B1298.lr.ph.i
  %86 = mul i64 %.2849.i, %s38
  %scevgep122.i = getelementptr i8, ptr %scevgep121.i, i64 %86
  %87 = mul i64 %.2902.i, %s38
  %scevgep127.i = getelementptr i8, ptr %scevgep121.i, i64 %87
  %88 = add i64 %.2956.i, %lsr.iv132.i
  %89 = mul i64 %88, %s38
  %scevgep134.i = getelementptr i8, ptr %scevgep121.i, i64 %89
  br label %B1298.i

_ZN7msf_jax4host4meso7kernels3cutB3v65B54c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2AZLaAIAE385Surface_28array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28bool_2c_201d_2c_20C_29_2c_20array_28bool_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B104.loopexit.i, %0
  ret i64 0
}


